// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/sheets_text.h"

#include "app/base/number.h"
#include "app/formats/svg/attribute_text.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/scanner.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace app::svg {
namespace {

constexpr std::string_view landscapeWord = " landscape", emptyWritten = "written";
constexpr qsizetype longestPaper = 100; // letters

struct MarkWord {
    std::string_view word;
    bool SheetMarks::*wanted;
};
constexpr std::array markWords{MarkWord{"registration", &SheetMarks::registration},
                               MarkWord{"labels", &SheetMarks::labels},
                               MarkWord{"crop", &SheetMarks::cropLines}};

struct LengthName {
    std::string_view name;
    double TilePlan::*length;
};
constexpr std::array lengthNames{LengthName{"margin", &TilePlan::margin},
                                 LengthName{"overlap", &TilePlan::overlap},
                                 LengthName{"scale", &TilePlan::scale}};

std::string marksText(const SheetMarks& marks)
{
    std::string text;
    for (const auto& [word, wanted] : markWords)
        if (marks.*wanted)
            (text += text.empty() ? "" : " ") += word;
    return text;
}

// Reads numbers with blanks or commas between them.
std::optional<std::vector<double>> sheetNumbers(std::string_view text)
{
    constexpr std::string_view between = " ,";
    std::vector<double> numbers;
    for (std::size_t begin = text.find_first_not_of(between); begin < text.size();) {
        const std::size_t end = std::min(text.find_first_of(between, begin), text.size());
        const auto number = parseNumber(text.substr(begin, end - begin));
        if (!number || std::abs(*number) > largestCoordinate)
            return std::nullopt;
        numbers.push_back(*number);
        begin = text.find_first_not_of(between, end);
    }
    return numbers;
}

bool takeInteger(std::string_view text, int& to)
{
    const auto number = parseNumber(trimmed(text));
    if (!number || !(*number >= 1 && *number <= mostTiles) || *number != std::floor(*number))
        return false;
    to = int(*number);
    return true;
}

bool takeLeftOut(std::string_view text, std::vector<int>& to)
{
    const auto numbers = sheetNumbers(text);
    if (!numbers || numbers->size() > mostTiles)
        return false;
    for (const double number : *numbers)
        if (!(number >= 1 && number <= mostTiles) || number != std::floor(number))
            return false;
        else
            to.push_back(int(number));
    return true;
}

bool takeBeyond(std::string_view text, SheetsBeyond& to)
{
    const auto numbers = sheetNumbers(text);
    if (!numbers || (numbers->size() != 4 && !numbers->empty()))
        return false;
    if (numbers->empty())
        return true;
    for (const double number : *numbers)
        if (!(number >= 0 && number <= mostTiles) || number != std::floor(number))
            return false;
    to = {int((*numbers)[0]), int((*numbers)[1]), int((*numbers)[2]), int((*numbers)[3])};
    return true;
}

bool takeDivision(const Tree& tree, Node node, PageSheets& sheets)
{
    sheets.byNumber = tree.hasAttribute(node, "columns");
    TilePlan& plan = sheets.plan;
    if (sheets.byNumber)
        return takeInteger(tree.attribute(node, "columns"), plan.columns)
               && takeInteger(tree.attribute(node, "rows"), plan.rows);
    if (!tree.hasAttribute(node, "shift"))
        return true;
    const auto shift = sheetNumbers(tree.attribute(node, "shift"));
    if (shift && shift->size() == 2)
        plan.shift = {shift->front(), shift->back()};
    return shift && shift->size() == 2;
}

void takePaper(std::string_view text, PageSheets& sheets)
{
    sheets.landscape = text.ends_with(landscapeWord);
    if (sheets.landscape)
        text.remove_suffix(landscapeWord.size());
    sheets.paper = QString::fromUtf8(text).left(longestPaper);
}

std::optional<PageSheets> sheetsOf(const Tree& tree, Node node)
{
    PageSheets sheets;
    sheets.plan = {};
    takePaper(tree.attribute(node, "paper"), sheets);
    for (const auto& [name, length] : lengthNames) {
        const auto number = parseNumber(tree.attribute(node, name));
        if (!number || !(*number >= 0 && *number <= largestCoordinate))
            return std::nullopt;
        sheets.plan.*length = *number;
    }
    const std::string_view marks = tree.attribute(node, "marks");
    for (const auto& [word, wanted] : markWords)
        sheets.plan.marks.*wanted = marks.find(word) != std::string_view::npos;
    if (tree.attribute(node, "empty") == emptyWritten)
        sheets.plan.empty = EmptySheets::Written;
    if (!takeDivision(tree, node, sheets)
        || !takeLeftOut(tree.attribute(node, "left-out"), sheets.plan.leftOut)
        || !takeBeyond(tree.attribute(node, "beyond"), sheets.plan.beyond))
        return std::nullopt;
    return sheets;
}

} // namespace

std::string textOf(const std::optional<PageSheets>& sheets)
{
    if (!sheets)
        return {};
    const TilePlan& plan = sheets->plan;
    std::string text = "<clearcut:sheets";
    appendAttribute(text, "paper",
                    escaped(sheets->paper) + std::string(sheets->landscape ? landscapeWord : ""));
    if (sheets->byNumber) {
        appendAttribute(text, "columns", double(plan.columns));
        appendAttribute(text, "rows", double(plan.rows));
    }
    for (const auto& [name, length] : lengthNames)
        appendAttribute(text, name, plan.*length);
    if (!sheets->byNumber && plan.shift != Point(0))
        appendAttribute(text, "shift", std::array{plan.shift.x, plan.shift.y});
    if (plan.marks.any())
        appendAttribute(text, "marks", marksText(plan.marks));
    if (!plan.leftOut.empty())
        appendAttribute(text, "left-out",
                        std::vector<double>(plan.leftOut.begin(), plan.leftOut.end()));
    if (const auto& [left, top, right, bottom] = plan.beyond; plan.beyond.any())
        appendAttribute(text, "beyond",
                        std::array{double(left), double(top), double(right), double(bottom)});
    if (plan.empty == EmptySheets::Written)
        appendAttribute(text, "empty", emptyWritten);
    return text + "/>";
}

std::optional<PageSheets> readSheets(const Tree& tree, Report& report)
{
    std::optional<PageSheets> sheets;
    for (const Node metadata : Children(tree, 0)) {
        if (tree.name(metadata) != "metadata")
            continue;
        for (const Node node : Children(tree, metadata))
            if (tree.name(node) == "clearcut:sheets") {
                sheets = sheetsOf(tree, node);
                report.turnTo(tree.line(node));
                if (!sheets)
                    report.add(losses::unreadableSheets);
            }
    }
    return sheets;
}

} // namespace app::svg

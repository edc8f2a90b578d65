// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/scale_text.h"

#include "app/base/number.h"
#include "app/formats/svg/attribute_text.h"
#include "app/formats/svg/colour.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/scanner.h"

#include <algorithm>
#include <array>

namespace app::svg {
namespace {

constexpr std::array sidesInOrder{&PaperMargins::left, &PaperMargins::top, &PaperMargins::right,
                                  &PaperMargins::bottom};

bool takeRatio(std::string_view text, DrawingScale& scale)
{
    const auto ratio = parseNumber(trimmed(text));
    if (!ratio || !(*ratio >= DrawingScale::least && *ratio <= DrawingScale::most))
        return false;
    scale.ratio = *ratio;
    return true;
}

bool takeUnit(std::string_view text, DrawingScale& scale)
{
    const auto row = std::ranges::find(units(), trimmed(text), &UnitInfo::suffix);
    if (row == units().end() || !(row->millimetres > 0))
        return false;
    scale.unit = row->unit;
    return true;
}

bool takeMargins(std::string_view text, PaperMargins& margins)
{
    const auto words = wordsOf(text);
    if (words.size() != sidesInOrder.size())
        return false;
    PaperMargins read = margins;
    for (std::size_t i = 0; i < words.size(); ++i) {
        const auto side = parseNumber(words[i]);
        if (!side || !(*side >= 0 && *side <= largestCoordinate))
            return false;
        read.*sidesInOrder[i] = *side;
    }
    margins = read;
    return true;
}

void readElement(const Tree& tree, Node node, Page& page, Report& report)
{
    const auto take = [&](std::string_view name, auto read, auto& to) {
        return !tree.hasAttribute(node, name) || read(tree.attribute(node, name), to);
    };
    const auto takeBackground = [](std::string_view text, PageBackground& background) {
        const auto colour = parseColour(text);
        background.colour = colour.value_or(background.colour);
        return colour.has_value();
    };
    const bool background = take("background", takeBackground, page.background);
    page.background.exported = tree.attribute(node, "export-background") == "yes";
    const bool ratio = take("scale", takeRatio, page.scale);
    const bool unit = take("unit", takeUnit, page.scale);
    const bool margins = take("margins", takeMargins, page.margins);
    page.margins.shown = tree.attribute(node, "show-margins") == "yes";
    report.turnTo(tree.line(node));
    if (!ratio || !unit || !margins || !background)
        report.add(losses::unreadableScale);
}

} // namespace

std::string scaleTextOf(const Page& page)
{
    std::string text;
    if (page.scale.ratio != 1)
        appendAttribute(text, "scale", page.scale.ratio);
    if (page.scale.unit)
        appendAttribute(text, "unit", infoOf(*page.scale.unit).suffix);
    const PaperMargins& margins = page.margins;
    PaperMargins hidden = margins;
    hidden.shown = false;
    if (hidden != PaperMargins{})
        appendAttribute(text, "margins",
                        std::array{margins.left, margins.top, margins.right, margins.bottom});
    if (margins.shown)
        appendAttribute(text, "show-margins", "yes");
    if (page.background.colour != PageBackground{}.colour)
        appendAttribute(text, "background", hexOf(page.background.colour));
    if (page.background.exported)
        appendAttribute(text, "export-background", "yes");
    return text.empty() ? text : "<clearcut:page" + text + "/>";
}

void readScale(const Tree& tree, Page& page, Report& report)
{
    for (const Node metadata : Children(tree, 0)) {
        if (tree.name(metadata) != "metadata")
            continue;
        for (const Node node : Children(tree, metadata))
            if (tree.name(node) == "clearcut:page")
                readElement(tree, node, page, report);
    }
}

} // namespace app::svg

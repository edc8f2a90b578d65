// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/difference_rows.h"

#include "app/base/csv_text.h"
#include "app/base/number.h"
#include "app/formats/coordinates.h"

#include <array>
#include <cmath>

namespace app {
namespace {

/// Which variant sees the line, in the order of Difference::Kind.
constexpr std::array kindWords{"only_a", "only_b", "ends"};

std::string number(double value)
{
    if (!std::isfinite(value))
        return std::isnan(value) ? "nan" : "inf";
    std::string text;
    appendNumber(text, value);
    return text;
}

std::string csvLine(const QStringList& fields)
{
    std::string line;
    for (const QString& field : fields) {
        line += line.empty() ? "" : ",";
        csv::appendField(line, field.toStdString());
    }
    return line;
}

using Fields = std::array<std::string, 12>;

void set(Fields& fields, std::size_t first, const std::optional<clipping::Segment>& piece)
{
    if (!piece)
        return;
    const auto& [a, b] = *piece;
    for (const double coordinate : {a.x, a.y, b.x, b.y})
        fields[first++] = number(coordinate);
}

} // namespace

void DifferenceTotals::add(const DifferenceTotals& more)
{
    lines += more.lines;
    counts.onlyA += more.counts.onlyA;
    counts.onlyB += more.counts.onlyB;
    counts.endsApart += more.counts.endsApart;
}

QStringList differenceNames()
{
    return {"line", "shape", "differs", "ulps", "a_x1", "a_y1",
            "a_x2", "a_y2",  "b_x1",    "b_y1", "b_x2", "b_y2"};
}

std::string differenceHeader()
{
    return csvLine(differenceNames() << "a"
                                     << "b"
                                     << "ulps_allowed"
                                     << "window")
           + '\n';
}

std::vector<std::pair<QString, QString>> factsOf(const ComparedAt& at)
{
    return {{"a", keyOf(at.comparison.a)},
            {"b", keyOf(at.comparison.b)},
            {"ulps_allowed", QString::number(allowedAt(at.window, at.comparison))},
            {"window", rectangleText(at.window.steps.front().box)}};
}

DifferenceRows::DifferenceRows(const ComparedAt& at, Form form) : at_(at), form_(form)
{
    QStringList values;
    for (const auto& [name, value] : factsOf(at))
        values << value;
    facts_ = ',' + csvLine(values) + '\n';
}

void DifferenceRows::compare(std::span<const clipping::Segment> lines,
                             const std::function<Numbers(std::size_t)>& numbersOf)
{
    const Differences found = differencesAt(at_.window, at_.comparison, lines);
    csv_.clear();
    fields_.clear();
    totals_ = {found.lines, counted(found.list)};
    if (form_ == Form::None)
        return;
    auto piece = found.pieces.begin();
    for (const Difference& difference : found.list) {
        Piece a, b;
        if (difference.kind != Difference::Kind::OnlyB)
            a = piece++->segment;
        if (difference.kind != Difference::Kind::OnlyA)
            b = piece++->segment;
        add(difference, numbersOf(difference.source), a, b);
    }
}

void DifferenceRows::add(const Difference& difference, const Numbers& numbers, const Piece& a,
                         const Piece& b)
{
    Fields fields{std::to_string(numbers.line), std::to_string(numbers.shape),
                  kindWords[std::size_t(difference.kind)],
                  QString::number(difference.ulps, 'g', 6).toStdString()};
    set(fields, 4, a);
    set(fields, 8, b);
    if (form_ == Form::Fields) {
        QStringList& row = fields_.emplace_back();
        for (const std::string& field : fields)
            row << QString::fromStdString(field);
        return;
    }
    for (std::size_t i = 0; i < fields.size(); ++i)
        (csv_ += i > 0 ? "," : "") += fields[i]; // numbers and words need no quotation marks
    csv_ += facts_;
}

} // namespace app

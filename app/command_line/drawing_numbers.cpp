// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/drawing_numbers.h"

#include "app/base/text.h"
#include "app/command_line/command.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

bool isBare(const Length& length) { return length.unit == Unit::User; }

// Plain numbers and lengths have different origins, so a shape of both would be misplaced.
void refuseMixture(const GivenValue& value, const std::vector<Length>& lengths)
{
    const bool four = lengths.size() == 4;
    if (std::ranges::any_of(lengths, isBare) && !std::ranges::all_of(lengths, isBare))
        throw WrongUsage{
            Text::tr(
                "--%1 %2: give all %3 with a unit, or all %4 without. With a unit they count from "
                "the paper's top left corner, without one they are the drawing's own coordinates.")
                .arg(value.option, value.text,
                     four ? Text::tr("four numbers") : Text::tr("numbers"),
                     four ? Text::tr("four") : Text::tr("numbers"))};
}

double finite(double number)
{
    if (!std::isfinite(number))
        throw WrongUsage{Text::tr("The window is too large for this drawing's unit: give "
                                  "smaller lengths.")};
    return number;
}

} // namespace

Point cornerOf(const Imported& imported)
{
    return imported.paged ? imported.document.page().min : Point{};
}

DrawingNumbers::DrawingNumbers(const GivenValue& value, const QString& numbers,
                               const QString& expected, const Imported& imported)
    : lengths_(lengthsOf(value, numbers, expected)), corner_(cornerOf(imported)),
      millimetresPerUnit_(imported.document.page().realMillimetresPerUnit())
{
    refuseMixture(value, lengths_);
}

double DrawingNumbers::length(std::size_t i) const
{
    const Length& length = lengths_[i];
    return finite(isBare(length) ? length.value : toUserUnits(length, millimetresPerUnit_));
}

Point DrawingNumbers::point(std::size_t i) const
{
    const Point from = isBare(lengths_[i]) ? Point{} : corner_;
    return {finite(from.x + length(i)), finite(from.y + length(i + 1))};
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tiles/tiling.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/tiles/left_out.h"

#include <glm/common.hpp>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr double leastScale = 1e-3, mostScale = 1e3;

QString millimetres(double length)
{
    const double shown = std::floor(length * 100) / 100; // a limit is never rounded up
    const int decimals = shown == std::round(shown) ? 0 : infoOf(Unit::Mm).decimals;
    return QStringLiteral("%1\u00a0mm").arg(numberText(shown, decimals));
}

/// One direction of the division: along x or y.
struct Row {
    double sheet, part;        ///< a sheet, and what is drawn on it, in millimetres
    int count;                 ///< sheets of the page
    double shift;              ///< the first of them begins so far before the page
    int before = 0, after = 0; ///< sheets beyond the page

    int all() const { return before + count + after; }
};

/// A length on the sheets, from the page's corner, in millimetres.
struct Reach {
    double from, to;
};

constexpr double rounding = 1e-9; // of a step: a sheet more for it would be empty

// How many parts cover the length.
int countFor(double length, double part, double overlap)
{
    const double count = std::ceil((length - overlap) / (part - overlap) - rounding);
    return int(std::clamp(count, 1.0, mostTiles + 1.0));
}

// How many further sheets cover a length beyond the others; 0 for what is not a number.
int furtherFor(double length, double step)
{
    if (!(length > leastBeyond && step > 0))
        return 0;
    return int(std::min(std::ceil(length / step - rounding), mostTiles + 1.0));
}

Row rowOf(double length, int axis, const TilePlan& plan)
{
    if (plan.sheet[axis] == 0) {
        const int count = axis == 0 ? plan.columns : plan.rows;
        const double part = (length + (count - 1) * plan.overlap) / count;
        return {part + 2 * plan.margin, part, count, 0};
    }
    const double part = plan.sheet[axis] - 2 * plan.margin, step = part - plan.overlap;
    if (!(step > 0))
        return {plan.sheet[axis], part, 0, 0};
    const double shift = plan.shift[axis] - std::floor(plan.shift[axis] / step) * step;
    return {plan.sheet[axis], part, countFor(length + shift, part, plan.overlap), shift};
}

Row extended(Row row, double overlap, const Reach& drawn)
{
    const double step = row.part - overlap;
    row.before = furtherFor(-row.shift - drawn.from, step);
    row.after = furtherFor(drawn.to - (row.count * step + overlap - row.shift), step);
    return row;
}

QString refusalOf(const TilePlan& plan, const Row& across, const Row& down)
{
    if (!(plan.scale >= leastScale && plan.scale <= mostScale))
        return Text::tr("The scale must be between 0.1 % and 100,000 %.");
    if (!(plan.margin >= 0 && plan.overlap >= 0))
        return Text::tr("Margin and overlap of sheets must not be negative.");
    if (plan.marks.any() && plan.margin < leastMarkedMargin)
        return Text::tr("Marks need a margin of at least %1 on each sheet.")
            .arg(millimetres(leastMarkedMargin));
    if (!(across.part > 0 && down.part > 0))
        return Text::tr("The margin of %1 is too large: nothing of a sheet is left.")
            .arg(millimetres(plan.margin));
    if (const double part = std::min(across.part, down.part); !(plan.overlap < part))
        return Text::tr("Overlap must be less than %1, the %2 of a sheet.")
            .arg(millimetres(part), part == across.part ? Text::tr("width") : Text::tr("height"));
    if (across.count < 1 || down.count < 1 || across.count * down.count > mostTiles)
        return Text::tr("The drawing needs more than %1 sheets. Choose larger ones.")
            .arg(mostTiles);
    if (across.all() * down.all() > mostTiles)
        return Text::tr("What lies beyond the page needs more than %1 sheets. Hide it, lay a clip "
                        "window on the page, or choose larger sheets.")
            .arg(mostTiles);
    return {};
}

} // namespace

int Tiling::written() const { return int(std::ranges::count(tiles, false, &Tile::leftOut)); }

Result<Tiling> tilingOf(const Page& page, const TilePlan& plan,
                        const std::optional<clipping::Window>& drawn)
{
    const double unit = page.millimetresPerUnit() * plan.scale;
    const auto rowAlong = [&](int axis) {
        const Row row = rowOf(page.size[axis] * unit, axis, plan);
        const auto onSheets = [&](const Point& p) { return (p[axis] - page.min[axis]) * unit; };
        return drawn ? extended(row, plan.overlap, {onSheets(drawn->min), onSheets(drawn->max)})
                     : row;
    };
    const Row across = rowAlong(0), down = rowAlong(1);
    if (const QString refusal = refusalOf(plan, across, down); !refusal.isEmpty())
        return Result<Tiling>::failure(refusal);
    Tiling tiling{{across.sheet, down.sheet}, across.all(), down.all()};
    tiling.beyond = {across.before, down.before, across.after, down.after};
    tiling.millimetresPerUnit = unit;
    tiling.overlap = plan.overlap / unit;
    const clipping::Window paper = page.rectangle();
    tiling.drawing =
        drawn ? (glm::max(paper.max, drawn->max) - glm::min(paper.min, drawn->min)) * unit
              : page.size * unit;
    const Point part = Point(across.part, down.part) / unit;
    const Point step = part - tiling.overlap;
    const Point first = page.min - Point(across.shift, down.shift) / unit;
    for (int row = 0; row < tiling.rows; ++row)
        for (int column = 0; column < tiling.columns; ++column) {
            const Point min = first + step * Point(column - across.before, row - down.before);
            Tile tile{row + 1, column + 1, {min, min + part}};
            tile.leftOut = isLeftOut(plan, tiling, tile);
            tiling.tiles.push_back(tile);
        }
    return Result<Tiling>::of(std::move(tiling));
}

} // namespace app

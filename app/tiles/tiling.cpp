// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/tiles/tiling.h"

#include "app/base/numbers.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("Tiles", text); }

QString millimetres(double length) { return lengthText(length, Unit::Mm, 1); }

/// One direction of the division: along x or y.
struct Row {
    double sheet, part; ///< a sheet, and what is drawn on it, in millimetres
    int count;
};

// How many parts cover the length. A part more for a rounding error would be empty.
int countFor(double length, double part, double overlap)
{
    constexpr double rounding = 1e-9;
    const double count = std::ceil((length - overlap) / (part - overlap) - rounding);
    return int(std::clamp(count, 1.0, mostTiles + 1.0));
}

Row rowOf(double length, double sheet, int count, const TilePlan& plan)
{
    if (sheet == 0) {
        const double part = (length + (count - 1) * plan.overlap) / count;
        return {part + 2 * plan.margin, part, count};
    }
    const double part = sheet - 2 * plan.margin;
    return {sheet, part, part > plan.overlap ? countFor(length, part, plan.overlap) : 0};
}

QString refusalOf(const TilePlan& plan, const Row& across, const Row& down)
{
    if (!(plan.margin >= 0 && plan.overlap >= 0))
        return tr("Margin and overlap of sheets must not be negative.");
    if (plan.marks && plan.margin < leastMarkedMargin)
        return tr("Marks need a margin of at least %1 on each sheet.")
            .arg(millimetres(leastMarkedMargin));
    if (!(across.part > 0 && down.part > 0))
        return tr("The margin of %1 is too large: nothing of a sheet is left.")
            .arg(millimetres(plan.margin));
    if (const double part = std::min(across.part, down.part); !(plan.overlap < part))
        return tr("The overlap must be less than %1, the %2 of the drawing on a sheet.")
            .arg(millimetres(part), part == across.part ? tr("width") : tr("height"));
    if (across.count < 1 || down.count < 1 || across.count * down.count > mostTiles)
        return tr("The drawing needs more than %1 sheets. Choose larger ones.").arg(mostTiles);
    return {};
}

} // namespace

Result<Tiling> tilingOf(const Page& page, const TilePlan& plan)
{
    const double unit = page.millimetresPerUnit();
    const Row across = rowOf(page.size.x * unit, plan.sheet.x, plan.columns, plan);
    const Row down = rowOf(page.size.y * unit, plan.sheet.y, plan.rows, plan);
    if (const QString refusal = refusalOf(plan, across, down); !refusal.isEmpty())
        return Result<Tiling>::failure(refusal);
    Tiling tiling{{across.sheet, down.sheet}, across.count, down.count};
    const Point part = Point(across.part, down.part) / unit;
    const Point step = part - plan.overlap / unit;
    for (int row = 0; row < down.count; ++row)
        for (int column = 0; column < across.count; ++column) {
            const Point min = page.min + step * Point(column, row);
            tiling.tiles.push_back({row + 1, column + 1, {min, min + part}});
        }
    return Result<Tiling>::of(std::move(tiling));
}

} // namespace app

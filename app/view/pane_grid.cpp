// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/pane_grid.h"

#include <algorithm>

namespace app {

namespace {

struct PaneCells {
    int columns, rows;
};

int length(int whole, int parts) { return std::max(0, (whole - (parts - 1) * paneGap) / parts); }

QSize cellSize(const QSize& area, const PaneCells& grid)
{
    return {length(area.width(), grid.columns), length(area.height(), grid.rows)};
}

PaneCells gridFor(const QSize& area, int count, double breadth)
{
    const auto drawingHeight = [&](const PaneCells& grid) {
        const QSize cell = cellSize(area, grid);
        return std::min(cell.width() / breadth, double(cell.height() - paneHeading));
    };
    PaneCells best{1, count};
    for (int columns = 2; columns <= count; ++columns)
        if (const PaneCells grid{columns, (count + columns - 1) / columns};
            drawingHeight(grid) > drawingHeight(best))
            best = grid;
    return best;
}

/// The start of the i-th of `parts` parts; the first gaps are wider by the remaining pixels.
int start(int whole, int parts, int i)
{
    const int size = length(whole, parts);
    const int over = std::max(0, whole - parts * size - (parts - 1) * paneGap);
    return i * (size + paneGap) + std::min(i, over);
}

bool hasRoom(const QSize& area, int count, double breadth)
{
    constexpr QSize few(200, 150), many(148, 128); // pixels; many need only be told apart
    const QSize cell = cellSize(area, gridFor(area, count, breadth));
    const QSize least = count > 4 ? many : few;
    return cell.width() >= least.width() && cell.height() >= least.height();
}

} // namespace

std::vector<QRect> paneCells(const QSize& area, int count, double breadth)
{
    const PaneCells grid = gridFor(area, count, breadth);
    const QSize size = cellSize(area, grid);
    std::vector<QRect> cells;
    cells.reserve(std::size_t(count));
    for (int i = 0; i < count; ++i)
        cells.push_back({QPoint(start(area.width(), grid.columns, i % grid.columns),
                                start(area.height(), grid.rows, i / grid.columns)),
                         size});
    return cells;
}

int panesWithRoom(const QSize& area, int count, double breadth)
{
    for (const int fewer : {count, 4, 2})
        if (fewer <= count && hasRoom(area, fewer, breadth))
            return fewer;
    return 1;
}

} // namespace app

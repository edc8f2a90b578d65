// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/document/page.h"

#include <optional>
#include <vector>

namespace app {

/// The part of the drawing on one sheet.
struct Tile {
    int row, column;         ///< from 1, from the top left
    clipping::Window window; ///< in user units, without the margins
    bool leftOut = false;    ///< is not written
    bool empty = false;      ///< is left out because nothing is drawn on it
};

/// All sheets, row by row. Those of the page begin at its top left corner; the last ones may reach
/// beyond the page. Whole sheets are added on each side where something is drawn beyond these.
struct Tiling {
    Point sheet; ///< in millimetres
    int columns = 0, rows = 0;
    std::vector<Tile> tiles{};
    double millimetresPerUnit = 1; ///< on the sheets
    double overlap = 0;            ///< in user units
    Point drawing{0, 0}; ///< size on paper of the page and of what is drawn beyond it; millimetres
    SheetsBeyond beyond{};

    int pageColumns() const { return columns - beyond.left - beyond.right; }
    int pageRows() const { return rows - beyond.top - beyond.bottom; }
    int numberOf(const Tile& tile) const { return (tile.row - 1) * columns + tile.column; }
    int written() const; ///< number of sheets that are not left out
    /// All sheets together, in user units.
    clipping::Window whole() const { return {tiles.front().window.min, tiles.back().window.max}; }
};

/// The smallest margin with room for marks.
constexpr double leastMarkedMargin = 5;

/// What reaches less beyond the sheets of a page, in millimetres on paper, needs no further ones:
/// files with rounded numbers have lines there that belong on the page's edge.
constexpr double leastBeyond = 0.1;

/// The sheets for a page and for what is drawn beyond it; `drawn`: the bounds of all lines, empty
/// without any. The error is a sentence that says what to change.
Result<Tiling> tilingOf(const Page& page, const TilePlan& plan,
                        const std::optional<clipping::Window>& drawn = std::nullopt);

} // namespace app

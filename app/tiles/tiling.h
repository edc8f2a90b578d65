// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/document/page.h"

#include <vector>

namespace app {

/// How a large drawing is divided among sheets of paper. Lengths are in millimetres on paper.
struct TilePlan {
    Point sheet{0, 0};         ///< of paper; (0, 0): just large enough for `columns` and `rows`
    int columns = 1, rows = 1; ///< only used without `sheet`
    double margin = 10;        ///< of each sheet, on all four sides; nothing is drawn there
    double overlap = 0;        ///< the strip that two neighbouring sheets have in common
    bool marks = false;        ///< registration marks, corner lines and a label on each sheet
    friend bool operator==(const TilePlan&, const TilePlan&) = default;
};

/// The part of the drawing on one sheet.
struct Tile {
    int row, column;         ///< from 1, from the top left
    clipping::Window window; ///< in user units, without the margins
};

/// All sheets, row by row. They begin at the page's top left corner; the last ones may reach beyond
/// the page.
struct Tiling {
    Point sheet; ///< in millimetres
    int columns = 0, rows = 0;
    std::vector<Tile> tiles{};
};

constexpr int mostTiles = 1000;
/// The smallest margin with room for marks.
constexpr double leastMarkedMargin = 5;

/// The sheets for a page. The error is a sentence that says what to change.
Result<Tiling> tilingOf(const Page& page, const TilePlan& plan);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/document/page.h"

#include <vector>

namespace app {

/// What is drawn in the margins of each sheet.
struct SheetMarks {
    bool registration = false; ///< at the same points of the drawing on neighbouring sheets
    bool labels = false;       ///< title, place of the sheet, size of all sheets together
    bool cropLines = false;    ///< at the corners
    bool any() const { return registration || labels || cropLines; }
    friend bool operator==(const SheetMarks&, const SheetMarks&) = default;
};
constexpr SheetMarks allMarks{true, true, true};

/// Whether sheets without any part of the drawing are written.
enum class EmptySheets : std::uint8_t { LeftOut, Written };

/// How a large drawing is divided among sheets of paper. Lengths are in millimetres on paper.
struct TilePlan {
    Point sheet{0, 0};         ///< of paper; (0, 0): just large enough for `columns` and `rows`
    int columns = 1, rows = 1; ///< only used without `sheet`
    double margin = 10;        ///< of each sheet, on all four sides; nothing is drawn there
    double overlap = 0;        ///< the strip that two neighbouring sheets have in common
    SheetMarks marks{};
    double scale = 1; ///< size on paper ÷ size in the drawing; strokes are scaled, too
    /// The first sheet begins so far left of and above the page. Only used with `sheet`.
    Point shift{0, 0};
    std::vector<int> leftOut{};               ///< numbers of sheets that are not written
    EmptySheets empty = EmptySheets::LeftOut; ///< see empty_sheets.h
    friend bool operator==(const TilePlan&, const TilePlan&) = default;
};

/// The part of the drawing on one sheet.
struct Tile {
    int row, column;         ///< from 1, from the top left
    clipping::Window window; ///< in user units, without the margins
    bool leftOut = false;    ///< is not written
    bool empty = false;      ///< is left out because nothing is drawn on it
};

/// All sheets, row by row. They begin at the page's top left corner; the last ones may reach beyond
/// the page.
struct Tiling {
    Point sheet; ///< in millimetres
    int columns = 0, rows = 0;
    std::vector<Tile> tiles{};
    double millimetresPerUnit = 1; ///< on the sheets
    double overlap = 0;            ///< in user units
    Point drawing{0, 0};           ///< the size of the page on the sheets, in millimetres

    int numberOf(const Tile& tile) const { return (tile.row - 1) * columns + tile.column; }
    int written() const; ///< number of sheets that are not left out
    /// All sheets together, in user units.
    clipping::Window whole() const { return {tiles.front().window.min, tiles.back().window.max}; }
};

constexpr int mostTiles = 1000;
/// The smallest margin with room for marks.
constexpr double leastMarkedMargin = 5;

/// The sheets for a page. The error is a sentence that says what to change.
Result<Tiling> tilingOf(const Page& page, const TilePlan& plan);

} // namespace app

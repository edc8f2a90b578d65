// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/subpath.h"

#include <QString>

namespace app {

constexpr int mostTiles = 1000; ///< sheets of one drawing

/// The marks in the margins of each sheet.
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

/// The sheets among which a drawing is divided, as a person has chosen them.
struct PageSheets {
    QString paper = QStringLiteral("A4"); ///< its name; unknown: as A4
    bool landscape = false;
    bool byNumber = false; ///< of columns and rows, not by the size of the paper
    /// The rest of the plan; its `sheet` does not count.
    TilePlan plan{.columns = 2, .rows = 2, .margin = 10, .overlap = 10, .marks = allMarks};
    friend bool operator==(const PageSheets&, const PageSheets&) = default;
};

} // namespace app

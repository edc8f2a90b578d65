// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/length.h"
#include "app/document/subpath.h"

#include <QString>

#include <optional>
#include <vector>

namespace app {

/// A straight line on the page that is never cut, printed or exported: points snap to it.
struct Guide {
    int axis;  ///< 0: vertical, at x; 1: horizontal, at y
    double at; ///< in user units
    friend bool operator==(const Guide&, const Guide&) = default;
};

struct Guides {
    static constexpr std::size_t most = 1000; ///< guides of a page
    std::vector<Guide> list{};                ///< the newest last
    friend bool operator==(const Guides&, const Guides&) = default;
};

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

/// Whole sheets that lie beyond the page, because something is drawn there.
struct SheetsBeyond {
    int left = 0, top = 0, right = 0, bottom = 0;
    bool any() const { return left > 0 || top > 0 || right > 0 || bottom > 0; }
    friend bool operator==(const SheetsBeyond&, const SheetsBeyond&) = default;
};

/// How a large drawing is divided among sheets of paper. Lengths are in millimetres on paper.
struct TilePlan {
    Point sheet{0, 0};         ///< of paper; (0, 0): just large enough for `columns` and `rows`
    int columns = 1, rows = 1; ///< of the page; only used without `sheet`
    double margin = 10;        ///< of each sheet, on all four sides; nothing is drawn there
    double overlap = 0;        ///< the strip that two neighbouring sheets have in common
    SheetMarks marks{};
    double scale = 1; ///< size on paper ÷ size in the drawing; strokes are scaled, too
    /// The first sheet begins so far left of and above the page. Only used with `sheet`.
    Point shift{0, 0};
    std::vector<int> leftOut{};               ///< numbers of sheets that are not written
    SheetsBeyond beyond{};                    ///< the sheets that `leftOut` counts, too
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

/// The page: its rectangle in user units (the whole sheet of paper; the viewBox of an SVG) and its
/// size on paper. Lengths with a unit are measured from `min`, the top left corner of the paper.
struct Page {
    Point min{0, 0};
    Point size{297, 210};
    Length width{297, Unit::Mm}, height{210, Unit::Mm};
    Guides guides{};
    std::optional<PageSheets> sheets{}; ///< how it is divided, if a person has chosen it
    friend bool operator==(const Page&, const Page&) = default;

    /// The size of a user unit in millimetres; 25.4 / 96 (1 px) if the file does not give it.
    double millimetresPerUnit() const;
    /// The unit in which lengths are displayed: the unit of the page width, or pixels if the width
    /// has none.
    Unit usualUnit() const;
    clipping::Window rectangle() const { return {min, min + size}; }
};

} // namespace app

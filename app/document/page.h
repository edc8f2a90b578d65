// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/length.h"
#include "app/document/style_table.h"
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

/// What lengths in the drawing mean. Coordinates are never multiplied by a scale: a smaller one
/// makes the page larger in user units.
struct DrawingScale {
    static constexpr double least = 1e-3, most = 1e7;
    double ratio = 1;           ///< a real length ÷ its length on paper: 50 at 1 : 50
    std::optional<Unit> unit{}; ///< of rulers, fields and labels; empty: that of the page's width
    friend bool operator==(const DrawingScale&, const DrawingScale&) = default;
};

/// The margins of the page, in millimetres on paper.
struct PaperMargins {
    double left = 10, top = 10, right = 10, bottom = 10;
    bool shown = false;
    bool same() const { return left == top && top == right && right == bottom; }
    friend bool operator==(const PaperMargins&, const PaperMargins&) = default;
};

/// The ground on which a drawing lies on its page.
struct PageBackground {
    Colour colour{255, 255, 255}; ///< alpha 0: nothing
    bool exported = false;        ///< in files that have one, unless another one is given
    friend bool operator==(const PageBackground&, const PageBackground&) = default;
};

/// The page: its rectangle in user units (the whole sheet of paper; the viewBox of an SVG) and its
/// size on paper. Lengths with a unit are measured from `min`, the top left corner of the paper.
struct Page {
    Point min{0, 0};
    Point size{297, 210};
    Length width{297, Unit::Mm}, height{210, Unit::Mm};
    Guides guides{};
    std::optional<PageSheets> sheets{}; ///< how it is divided, if a person has chosen it
    DrawingScale scale{};
    PaperMargins margins{};
    PageBackground background{};
    friend bool operator==(const Page&, const Page&) = default;

    /// The size of a user unit on paper in millimetres; 25.4 / 96 (1 px) if the file does not give
    /// it. For stroke widths, dashes, text sizes, margins, tolerances and all that is printed.
    double millimetresPerUnit() const;
    /// The real size of a user unit in millimetres: `scale.ratio` times that on paper. For all
    /// lengths of the drawing that a person reads or types.
    double realMillimetresPerUnit() const;
    /// The unit in which lengths are displayed: that of the scale, otherwise that of the page
    /// width, or pixels if the width has none.
    Unit usualUnit() const;
    /// The unit of lengths on paper, such as stroke widths, beside drawn lengths in `unit`:
    /// millimetres or inches, if a drawn length has another size than its picture on paper.
    Unit paperUnit(Unit unit) const;
    /// The ground that files get; empty: the usual one of their format.
    std::optional<Colour> exportedBackground() const
    {
        return background.exported ? std::optional(background.colour) : std::nullopt;
    }
    clipping::Window rectangle() const { return {min, min + size}; }
};

} // namespace app

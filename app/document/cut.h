// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/clip_windows.h"
#include "app/document/sheet.h"
#include "clipping/algorithm.h"

namespace app {

/// The shapes that a cut acts on. Everything: hidden and locked shapes too, so that no geometry
/// stays on the wrong side. Editable: hidden shapes and locked layers stay whole.
enum class Reach : std::uint8_t { Everything, Editable };

struct CutOptions {
    const clipping::Uses<clipping::Segment, clipping::Window>* algorithm = nullptr; ///< not null
    clipping::Window window{};
    Keep keep = Keep::Inside;
    double tolerance = 0;      ///< user units, flattening of curves; 0: 0.05 mm on paper
    bool keepContacts = false; ///< single points of a longer line (CSV keeps them)
    Reach reach = Reach::Everything;
};

/// Whether the shape has an area to fill; single straight lines have none. (SVG fills shapes
/// without a fill attribute, and some programs and PDF viewers then paint a hairline there.)
bool hasArea(const Shape& shape);

/// The colour of a shape's lines where nothing is filled: its stroke's or, without one, that of its
/// fill if there is an area to fill; nothing if the shape is not seen.
std::optional<Colour> lineInk(const Shape& shape);

/// Counts of shapes and segments after a cut, for the report.
struct CutCounts {
    std::size_t whole = 0;    ///< shapes that came back unchanged
    std::size_t cut = 0;      ///< shapes of which a part is left
    std::size_t gone = 0;     ///< shapes of which nothing is left
    std::size_t opened = 0;   ///< closed paths that are open now
    std::size_t unfilled = 0; ///< shapes that lost their fill (outlined in it if without stroke)
    std::size_t hidden = 0;   ///< hidden shapes that were cut like the others, and stay hidden
    std::size_t leftHidden = 0, leftLocked = 0;        ///< shapes that Reach::Editable left alone
    std::size_t segmentsBefore = 0, segmentsAfter = 0; ///< of the shapes that were cut
};

struct Cut {
    Sheet sheet; ///< same page, layers and window
    CutCounts counts;
    std::vector<std::size_t> sources; ///< for each shape of `sheet`, which shape it came from
};

/// The drawing really cut at the window, as the project's design says: consecutive visible parts
/// of one path form one path (across a closed path's start as well); shapes wholly kept come back
/// unchanged, closed and filled; cut ones are open and unfilled; cut curves are split, not replaced
/// by chords; every end made by a cut lies on the window's edge, bit for bit inside the window.
/// Hidden shapes stay hidden.
Cut cut(const Sheet& sheet, const CutOptions& options);

/// The drawing without its hidden shapes and layers.
Sheet withoutHidden(Sheet sheet);

} // namespace app

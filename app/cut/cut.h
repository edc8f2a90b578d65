// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/document.h"
#include "app/scene/region_clipping.h"

namespace app {

/// The objects that a cut acts on. Everything: hidden and locked ones too, so that no geometry
/// stays on the wrong side. Editable: what is hidden or locked stays whole.
enum class Reach : std::uint8_t { Everything, Editable };

struct CutOptions {
    ClipAll clipAll = nullptr; ///< of the algorithm; not null
    ClipRegion region{};       ///< without a window nothing is cut
    double tolerance = 0;      ///< user units, flattening of curves; 0: 0.05 mm on paper
    bool keepContacts = false; ///< single points of a longer line (CSV keeps them)
    Reach reach = Reach::Everything;
};

/// Counts of objects and lines after a cut, for the report.
struct CutCounts {
    std::size_t whole = 0;    ///< objects that came back unchanged
    std::size_t cut = 0;      ///< objects of which a part is left
    std::size_t gone = 0;     ///< objects of which nothing is left
    std::size_t opened = 0;   ///< closed subpaths that are open now
    std::size_t unfilled = 0; ///< objects that lost their fill (outlined in it if without stroke)
    std::size_t hidden = 0;   ///< hidden objects that were cut like the others, and stay hidden
    std::size_t leftHidden = 0, leftLocked = 0;        ///< objects that Reach::Editable left alone
    std::size_t segmentsBefore = 0, segmentsAfter = 0; ///< of the objects that were cut
};

struct Cut {
    /// What the cut does to the document. Clip windows stay, and so do objects wholly kept; of each
    /// other one a splice takes what is left. Layers stay, groups without objects go.
    Edit edit;
    CutCounts counts;
};

/// The document really cut at the clip windows: consecutive visible parts of one subpath form one
/// subpath (across a closed one's start as well); objects wholly kept are unchanged, closed and
/// filled; cut ones are open and unfilled; cut curves are split, not replaced by chords; every end
/// made by a cut lies on a window's edge, bit for bit inside the window. Hidden objects stay
/// hidden.
Cut cut(const Document& document, const CutOptions& options);

/// What a cut leaves of one object, bottom to top. The tolerance must be given.
std::vector<Object> cutAlone(const Object& object, const CutOptions& options);

/// For each object after the cut, which of the document's `objects` objects it came from.
std::vector<std::uint32_t> sourcesOf(const Cut& cut, std::size_t objects);

} // namespace app

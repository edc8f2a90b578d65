// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/progress.h"
#include "app/document/document.h"
#include "app/scene/region_clipping.h"

namespace app {

struct CutOptions {
    ClipAll clipAll = nullptr; ///< from the algorithm; not null
    ClipRegion region{};       ///< without a window nothing is cut
    double tolerance = 0;      ///< for curves, in user units; 0: 0.05 mm on paper
    bool keepContacts = false; ///< single points of a longer line (CSV keeps them)
    bool leaveLocked = false;  ///< locked objects stay whole
    bool leaveHidden = false;  ///< hidden objects stay whole
    bool leaveImages = false;  ///< images stay whole
    bool closeAreas = false;   ///< the stroke of a cut area runs along the cut, too
    double leastLength = 0;    ///< shorter pieces of cut lines are dropped (user units)
    double wideStroke = 0;     ///< the least for `CutCounts::slanted`; 0: none. 1 mm with `cutAt`
    /// Those of the region (`cutAt`): curves of the drawing that run along their curves are one
    /// with them (curved_border.h). Without windows such curves are cut like all others.
    ClipWindows windows{};
    double coincident = 0; ///< how far from them, in user units; 0: 1 µm on paper
};

/// Cuts at the windows of a drawing with this page.
void cutAt(CutOptions& options, const ClipWindows& windows, const Page& page);

class CurvedBorder;
/// With the border's windows as its polygons.
CutOptions atPolygons(CutOptions options, const CurvedBorder& border, const Page& page);

/// Counts of objects and lines after a cut, for the report.
struct CutCounts {
    std::size_t whole = 0; ///< objects that came back unchanged
    std::size_t cut = 0;   ///< objects of which a part remains
    std::size_t gone = 0;  ///< objects of which nothing remains
    /// Objects that only touch the windows, in single points. They count as neither cut nor gone,
    /// whether the points are kept or not.
    std::size_t touching = 0;
    std::size_t opened = 0; ///< closed subpaths with a stroke that became open
    std::size_t hidden = 0; ///< hidden objects that were cut like visible ones, and stay hidden
    std::size_t leftHidden = 0, leftLocked = 0; ///< not cut, as the options say
    std::size_t cutLocked = 0;    ///< objects on locked layers that a cut changed or removed
    std::size_t dropped = 0;      ///< pieces shorter than the least length
    std::size_t fillsRemoved = 0; ///< by app::occlude
    /// Objects with a wide stroke that a slanted edge cuts: it ends at right angles to its line,
    /// not along the edge. `strokesAsAreas` lets it end there.
    std::size_t slanted = 0;
    /// Images that are cut, at most at the rectangle around the windows; those of which more is
    /// left than the windows keep, in that rectangle or, where there is none, all; and those of
    /// which nothing is left.
    std::size_t imagesCut = 0, imagesUncut = 0, imagesWhole = 0, imagesGone = 0;
    std::size_t segmentsBefore = 0, segmentsAfter = 0; ///< of the objects that were cut
};

struct Cut {
    /// What the cut changes in the document. Clip windows and objects that are kept whole stay. One
    /// splice for each other object replaces it by what remains. Layers stay; groups left without
    /// objects are removed.
    Edit edit;
    CutCounts counts;
};

/// Cuts the document at its clip windows. Consecutive visible parts of one subpath form one subpath
/// (also across the start of a closed subpath). Further objects made of one get ids with a number,
/// "wall-2". Objects kept whole are unchanged; cut outlines
/// are open. A cut area stays filled (cut_object.h). If it has a stroke, it becomes a group in its
/// place, with its id: the area, and above it the lines, so that no stroke runs along the cut. With
/// `closeAreas` it stays one object instead, whose stroke follows the cut; its lines that enclose
/// nothing are then above it. Where a document can hold no further groups, the parts are objects
/// with numbered ids. Cut curves are split, not replaced by chords. Every end made by the cut lies
/// on a window's edge, bit for bit inside the window. Hidden objects stay hidden. When a stop is
/// requested, it returns within a tenth of a second, and the result is of no use.
Cut cut(const Document& document, const CutOptions& options, const Follower& follower = {});

/// What remains of one object, bottom to top. `options.tolerance` must not be 0.
std::vector<Object> cutAlone(const Object& object, const CutOptions& options);

/// For each object after the cut, the index of its source among the document's `objects` objects.
std::vector<std::uint32_t> sourcesOf(const Cut& cut, std::size_t objects);
/// Those of the document's `objects` objects of which something is left.
ObjectRanges leftBy(const Cut& cut, std::size_t objects);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/curved_border.h"
#include "app/document/flatten.h"
#include "app/document/object.h"
#include "app/scene/region.h"

#include <span>

namespace app {

/// The kept part of one chord of a flattened path, in the direction from a to b. An end that
/// differs from the chord's own end, in any bit, is a cut. `edgeA` and `edgeB` name the clip
/// window's edge that made the cut, or are Edge::NoEdge.
struct KeptPart {
    std::size_t chord;
    clipping::Segment segment;
    clipping::Edge edgeA = clipping::Edge::NoEdge, edgeB = clipping::Edge::NoEdge;
};

/// A part of a path that is kept without a gap; `before` is its distance along the path from the
/// path's start.
struct Run {
    Subpath path;
    double before;
};

/// Joins the kept parts of `path` into runs. `chords` are those of `flatten(path, …)`; `parts` are
/// in the path's order. Lines keep the ends of the parts bit for bit. Curves are split, not
/// replaced by chords: a cut moves to the point where the curve itself meets the edge. On a
/// horizontal or vertical edge one of its coordinates is the edge's own; for rectangles the other
/// stays within a window of `region` that has this edge. If everything is kept, the path is
/// returned unchanged; otherwise all runs are open. A run across the start of a closed path is one
/// run, except with ClosedStart::Break (for dashed strokes, whose dashes restart there). Cuts at a
/// curved border, of lines too, move to where that itself is met.
enum class ClosedStart : std::uint8_t { Join, Break };
std::vector<Run> joinRuns(const Subpath& path, std::span<const Chord> chords,
                          std::span<const KeptPart> parts, const ClipRegion& region,
                          ClosedStart closedStart, const CurvedBorder& border = {});

/// Makes one object of the runs, painted like `object`; or several where dashes must continue, as
/// an object has only one dash offset. Only the first keeps the id, title and description; none
/// keeps the recipe. Ends are butt caps, because other caps would reach beyond the cut; dashes
/// keep theirs.
std::vector<Object> objectsOfRuns(Object object, std::vector<Run> runs);

} // namespace app

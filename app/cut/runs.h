// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/flatten.h"
#include "app/document/object.h"
#include "app/scene/region.h"

#include <span>

namespace app {

/// What is kept of one chord of a flattened path, from its a's side to its b's side. An end that is
/// not the chord's own, bit for bit, is a cut; `edgeA` and `edgeB` name the edge of the clip window
/// that made it, Edge::None if it was none.
struct KeptPart {
    std::size_t chord;
    clipping::Segment segment;
    clipping::Edge edgeA = clipping::Edge::None, edgeB = clipping::Edge::None;
};

/// A part of a path that is kept without a gap, and how far along the path it begins.
struct Run {
    Subpath path;
    double before;
};

/// Joins what is kept of `path` into runs. `chords` are those of `flatten(path, …)`, `parts` come
/// in the path's order. Lines keep the ends of the parts bit for bit. Curves are split, not
/// replaced by chords: a cut moves to where the curve itself meets the edge, and that coordinate is
/// the edge's own; the other one stays within a window of `region` that has this edge. Where
/// everything is kept, the path comes back unchanged; otherwise runs are open, and one that goes
/// over a closed path's start is one run (not if `dashed`: there the dashes begin anew).
enum class OverStart : std::uint8_t { Join, Break };
std::vector<Run> joinRuns(const Subpath& path, std::span<const Chord> chords,
                          std::span<const KeptPart> parts, const ClipRegion& region,
                          OverStart overStart);

/// The runs as an object painted like `object`, and as several where dashes must go on from where
/// they were: an object has one dash offset. Only the first has its id, title and description; no
/// recipe makes what is left. Ends are butt, as a cap would reach beyond a cut.
std::vector<Object> objectsOfRuns(Object object, std::vector<Run> runs);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/curved_border.h"
#include "app/document/flatten.h"
#include "app/document/path.h"
#include "app/document/style_table.h"
#include "clipping/area/clip_area.h"

#include <optional>

namespace app {

/// The area of a flattened path, and where its edges come from.
struct FlatArea {
    /// A place in the path: a chord of one of its subpaths.
    struct Source {
        std::size_t subpath;
        Chord chord;
    };
    clipping::Area area;
    /// For each point of the area, the chord from it to the next one; empty for the line that
    /// closes an open subpath.
    std::vector<std::optional<Source>> sources{};
};
FlatArea flatAreaOf(const std::vector<Subpath>& path, FillRule rule, std::span<const Chord> chords);

/// The rings of a clipped area as closed subpaths, with the curves of `path` and of the border in
/// place of their chords.
std::vector<Subpath> subpathsOf(const clipping::ClippedArea& clipped,
                                const std::vector<Subpath>& path, const FlatArea& flat,
                                const clipping::PreparedRegion& windows,
                                const CurvedBorder& border);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/curved_border.h"
#include "app/cut/cut.h"
#include "app/document/flatten.h"
#include "app/document/path.h"
#include "app/document/style_table.h"
#include "app/scene/region.h"

#include <stop_token>

namespace app {

/// What the clip windows keep of a filled area.
struct AreaLeft {
    bool whole = false;           ///< all of it: the path stays as it is
    std::vector<Subpath> paths{}; ///< otherwise the area that is left, closed; none: nothing
};

/// Cuts filled areas at clip windows, with exact decisions, whichever algorithm cuts the lines.
class AreaCut {
public:
    /// When a stop is requested, what is left is of no use.
    explicit AreaCut(const ClipRegion& region, const std::stop_token& stop = {});

    /// `chords` are those of the path, all subpaths in order, within the tolerance of its curves;
    /// open subpaths are filled as if closed. Curves come back as parts of the same curves, which
    /// end where the curve itself crosses the window's edge; along `border` they are its curves.
    /// The result is filled alike by both fill rules.
    AreaLeft left(const Path& path, FillRule rule, std::span<const Chord> chords,
                  const CurvedBorder& border = {}) const;

private:
    std::shared_ptr<const clipping::PreparedRegion> windows_;
    std::stop_token stop_;
};

/// What remains of an object after a cut.
struct CutObject {
    bool whole = false;         ///< the whole object, unchanged
    std::vector<Object> left{}; ///< otherwise the remaining parts, bottom to top
    bool parted = false;        ///< `left` begins with the area, and its lines follow
    std::size_t opened = 0;     ///< closed subpaths that became open
    std::size_t dropped = 0;    ///< pieces shorter than the least length
    bool slanted = false;       ///< a wide stroke ends at a slanted edge (`CutCounts`)
};

/// Cuts an object, given the kept pieces of its lines, and the area that is left if it is filled.
/// `chords` are those of `flatten(object.path, options.tolerance)`. `pieces` are in the order of
/// the chords, and their sources count from `first`. Where they are cut at the curves of `border`,
/// its true curves count.
CutObject cutObject(const Object& object, const CutOptions& options, std::span<const Chord> chords,
                    std::span<const clipping::Clipped> pieces, std::size_t first,
                    const std::optional<AreaLeft>& area, const CurvedBorder& border = {});

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/curved_border.h"
#include "app/document/flatten.h"
#include "app/document/path.h"
#include "app/document/style.h"
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

} // namespace app

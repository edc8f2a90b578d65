// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"
#include "app/scene/region.h"

namespace app {

/// The type of `clipping::Functions::clipAll`.
using ClipAll = decltype(clipping::Functions<clipping::Segment, clipping::Window>::clipAll);

/// The form of the catalogue whose function this is; empty for any other function.
std::optional<Variant> variantOf(ClipAll clipAll);

/// The library's functions that clip at the windows of one region, for the variant that `usedAt`
/// chooses.
struct RowForms {
    bool exact = false; ///< the row `exact`
    ClipAll atWindow = nullptr;
    const clipping::Functions<clipping::Segment, clipping::ConvexPolygon>* atPolygon = nullptr;
    const clipping::Functions<clipping::Segment, clipping::ConvexPolygon>* atLongPolygon = nullptr;
    /// For all windows at once; null if they are clipped at one by one.
    clipping::RegionProgress (*atRegion)(std::span<const clipping::Segment> in,
                                         const clipping::PreparedRegion& region,
                                         std::span<clipping::RegionPiece> out,
                                         clipping::RegionProgress from) = nullptr;
};
RowForms formsAt(const ClipRegion& region, ClipAll clipAll);

/// Clips lines at one window, as `clipAll` does. `Clipped::cut` names the edge, or `borderEdge`.
std::size_t clipAtStep(const RowForms& forms, const ClipRegion::Step& step,
                       std::span<const clipping::Segment> lines, std::span<clipping::Clipped> out);

} // namespace app

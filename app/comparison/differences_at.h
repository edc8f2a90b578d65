// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/live_differences.h"
#include "app/scene/compared_window.h"
#include "app/scene/region.h"

#include <QString>

namespace app {

// Comparing two variants at a window of any shape at which both can clip: a rectangle, also a
// rotated one, or a convex polygon.

/// Why a variant cannot be compared at a window: "Liang-Barsky clips at rectangles only; this
/// window is convex, 64 edges." Empty if it can.
QString refusalAt(const ClipRegion::Step& step, const Variant& variant);

/// The parts of the lines inside the window, clipped by a variant, in the order of the lines.
std::vector<clipping::Clipped> clippedAt(const ClipRegion& window, const Variant& variant,
                                         std::span<const clipping::Segment> lines);

/// How far both together may be off there, in ulps.
double allowedAt(const ClipRegion& window, const Comparison& comparison);

/// The differences of these lines at one window that adds; `Differences::window` is its bounding
/// box. A limit in ulps in the comparison holds.
Differences differencesAt(const ClipRegion& window, const Comparison& comparison,
                          std::span<const clipping::Segment> lines);

/// For captions: says that algorithms are compared at the page. Empty if there is a clip window.
QString atText(const ComparedWindow& window);

} // namespace app

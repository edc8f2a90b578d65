// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cut/cut.h"

namespace app {

/// The area that a stroke covers, with its caps, joins and dashes, within `tolerance` (user units,
/// > 0), or a millionth of the path's size: closed subpaths, which fill it by both fill rules.
/// Empty if the style has no stroke, if nothing of it is seen, and when a stop is requested.
std::vector<Subpath> strokeArea(const Path& path, const Style& style, double tolerance,
                                const std::stop_token& stop = {});

constexpr double strokeMillimetres = 0.01; ///< how far the areas of strokes may be off, on paper

/// Replaces the strokes of these objects by filled areas. A filled object
/// becomes a group with its id: the filled area, and above it that of the stroke. Objects whose
/// stroke is not seen stay as they are. When a stop is requested, the result is of no use.
Cut strokesAsAreas(const Document& document, const ObjectRanges& objects,
                   const Follower& follower = {});

} // namespace app

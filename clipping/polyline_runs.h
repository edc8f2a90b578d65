// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/polyline.h"

namespace clipping {

/// `clipPolyline` or `clipClosedPolyline` (polyline.h), for float or double.
template <class T>
void findRuns(std::span<const glm::vec<2, T>> points, bool closed, const BasicWindow<T>& window,
              BasicPolylineRuns<T>& out);

} // namespace clipping

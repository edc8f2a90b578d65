// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/visible_runs.h"

namespace clipping {

/// What polyline.h promises, for float and double.
template <class T>
void findRuns(const BasicPolyline<T>& polyline, const BasicWindow<T>& window,
              BasicPolylineRuns<T>& out);

} // namespace clipping

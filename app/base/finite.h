// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <cmath>

// Whether all coordinates are numbers, neither infinite nor NaN.

namespace app {

inline bool isFinite(const glm::dvec2& p) { return std::isfinite(p.x) && std::isfinite(p.y); }

inline bool isFinite(const clipping::Segment& s) { return isFinite(s.a) && isFinite(s.b); }

inline bool isFinite(const clipping::Window& w) { return isFinite(w.min) && isFinite(w.max); }

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/drawing/gesture_measure.h"

#include <string_view>

// What tools without numbers of their own keep for their next object in Workbench::kept: 1 for yes.

namespace ui {

/// The next line begins where the last one ends; a click where the first one began ends the chain.
constexpr std::string_view keptLine = "line";
constexpr app::Numbers usualLine{1, 1};

/// A polyline that is ended is closed.
constexpr std::string_view keptPolyline = "polyline";
constexpr app::Numbers usualPolyline{0};

} // namespace ui

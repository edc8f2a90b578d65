// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart.h"

namespace app {

/// A linear scale with round marks.
struct Axis {
    Interval range;            ///< what the panel shows
    std::vector<double> ticks; ///< round numbers within it, ascending
    int decimals;              ///< that they need
};

/// The axis of all of a chart's panels: bars start at zero and nothing goes beyond its ends. Not
/// more than about `ticks` marks.
Axis axisOf(const Chart& chart, int ticks);

} // namespace app

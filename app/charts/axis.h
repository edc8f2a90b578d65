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

/// The axis of a panel with `ticks` marks at most. Bars start at zero. Where a few of them would
/// leave no room for all the others, the axis ends before theirs do.
Axis axisOf(const Chart& chart, std::size_t panel, double ticks);

/// Whether that is so in any panel.
bool isBroken(const Chart& chart);

} // namespace app

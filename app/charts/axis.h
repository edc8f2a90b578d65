// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart.h"

namespace app {

/// A linear scale with round marks.
struct Axis {
    Interval range;            ///< the range that the panel shows
    std::vector<double> ticks; ///< round numbers within it, ascending
    int decimals;              ///< of the ticks
};

/// The axis of a panel with at most `ticks` ticks. Bars start at zero. If a few very long bars
/// would leave no room for the others, the axis ends before these bars do (they are broken).
Axis axisOf(const Chart& chart, std::size_t panel, double ticks);

/// Whether a bar is broken in any panel.
bool isBroken(const Chart& chart);

} // namespace app

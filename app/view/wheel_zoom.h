// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/view.h"

#include <optional>

namespace app {

/// Zooming by the wheel. While the pointer stays where it is, so many notches back give exactly,
/// bit for bit, the view from which so many notches came.
class WheelZoom {
public:
    /// One notch is a step of 20 %; a touchpad gives parts of one. Positive: in.
    void turn(View& view, const Point& screen, double notches);

private:
    struct Start {
        View view;
        Point screen;
        double notches;
        View last; ///< as this wheel left it: another view starts anew
    };
    std::optional<Start> start_;
};

} // namespace app

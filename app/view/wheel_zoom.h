// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/view.h"

#include <optional>

namespace app {

/// Zooms with the wheel. If the pointer does not move, turning back by the same number of notches
/// restores the view bit for bit.
class WheelZoom {
public:
    /// One notch zooms by 20 %; a touchpad reports fractions of a notch. Positive zooms in.
    void turn(View& view, const Point& screen, double notches);

private:
    struct Start {
        View view;
        Point screen;
        double notches;
        View last; ///< the view that this wheel set last: any other view starts anew
    };
    std::optional<Start> start_;
};

} // namespace app

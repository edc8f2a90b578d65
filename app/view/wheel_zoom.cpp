// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/wheel_zoom.h"

#include <cmath>

namespace app {

constexpr double notch = 1.2;

void WheelZoom::turn(View& view, const Point& screen, double notches)
{
    if (!start_ || start_->screen != screen || start_->last != view)
        start_ = Start{view, screen, 0, view};
    const double before = start_->notches;
    start_->notches += notches;
    if (std::abs(start_->notches) < 1e-9)
        start_->notches = 0;
    view = start_->view;
    if (start_->notches != 0)
        view.zoomAt(screen, std::pow(notch, start_->notches));
    if (view == start_->last)
        start_->notches = before; // at the limit of zooming: turning back begins here
    start_->last = view;
}

} // namespace app

// SPDX-License-Identifier: MIT
#include "clipping/convex_window.h"

#include "clipping/gradual_underflow.h"
#include "clipping/ieee_numbers.h"
#include "clipping/polygon/window_data.h"

#include <algorithm>
#include <cmath>

namespace clipping {

ConvexWindow::ConvexWindow(std::span<const glm::dvec2> corners)
{
    const GradualUnderflow here;
    if (corners.empty())
        return;
    if (!std::ranges::all_of(corners,
                             [](auto& p) { return std::isfinite(p.x) && std::isfinite(p.y); })) {
        whyNot_ = "A corner has a number that is not finite.";
        return;
    }
    auto polygon = prepared(corners, Order::Given);
    if (!polygon)
        polygon = prepared(corners, Order::Reversed);
    if (!polygon) {
        whyNot_ =
            "The polygon is not convex: it turns left and right, or goes round more than once.";
        return;
    }
    data_ = std::make_shared<const Data>(std::move(*polygon));
    whyNot_ = "";
}

} // namespace clipping

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/view.h"

#include <optional>
#include <vector>

namespace app {

/// The views before and after the present one, like the pages of a browser. Views in quick
/// succession (a drag, wheel notches) count as one.
class ViewHistory {
public:
    /// Call before the view changes from `view`. `now` is in milliseconds of any clock.
    void leave(const View& view, long long now);
    std::optional<View> back(const View& present);
    std::optional<View> forth(const View& present);

private:
    std::vector<View> before_, after_;
    long long last_ = -1'000'000;
};

} // namespace app

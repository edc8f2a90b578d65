// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/region/region.h"

#include <mutex>
#include <optional>

namespace app {

/// A region of the library that is prepared when it is first used: preparing one of many thousand
/// edges takes some tenths of a second, which the thread that only passes it on must not spend.
/// Owners on any threads may use it.
class LaterRegion {
public:
    explicit LaterRegion(clipping::Region region) : region_(std::move(region)) {}

    const clipping::PreparedRegion& prepared() const
    {
        std::call_once(once_, [this] {
            prepared_.emplace(region_);
            region_ = {};
        });
        return *prepared_;
    }

private:
    mutable std::once_flag once_;
    mutable clipping::Region region_; ///< until it is prepared
    mutable std::optional<clipping::PreparedRegion> prepared_;
};

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <cstddef>
#include <span>
#include <vector>

namespace app {

/// The pieces that a frame keeps: any number of groups, each in a row. They stay where they are
/// until `clear`. The memory serves for the next frame: writing to a new page costs more time than
/// clipping all lines that fill it.
class PieceStore {
public:
    void clear();
    /// Room for a group of that size. Valid until the next call.
    std::span<clipping::Clipped> room(std::size_t count);
    /// Keeps that many pieces, which are at the beginning of the last room.
    std::span<const clipping::Clipped> keep(std::size_t count);

private:
    static constexpr std::size_t mostInPage = 65'536; ///< unless a group has more

    std::vector<std::vector<clipping::Clipped>> pages_;
    std::size_t page_ = 0; ///< in which there is still room
    std::size_t used_ = 0; ///< pieces in it
};

} // namespace app

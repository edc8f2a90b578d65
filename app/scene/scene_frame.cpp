// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/scene_frame.h"

#include <algorithm>

namespace app {

void PieceStore::clear()
{
    // Frees pages that no frame has needed for a while: one with all lines may have been an
    // exception, as one may in which another thread clipped them.
    constexpr int frames = 32;
    mostPages_ = std::max(mostPages_, page_ + 1);
    if (++clears_ == frames) {
        pages_.resize(std::min(pages_.size(), 2 * mostPages_));
        mostPages_ = 0;
        clears_ = 0;
    }
    page_ = used_ = 0;
}

std::span<clipping::Clipped> PieceStore::room(std::size_t count)
{
    while (page_ < pages_.size() && pages_[page_].size() - used_ < count) {
        ++page_;
        used_ = 0;
    }
    if (page_ == pages_.size()) {
        const std::size_t before = pages_.empty() ? 0 : pages_.back().size();
        pages_.emplace_back(std::max(count, std::min(2 * before, mostInPage)));
    }
    return std::span(pages_[page_]).subspan(used_, count);
}

std::span<const clipping::Clipped> PieceStore::keep(std::size_t count)
{
    if (page_ == pages_.size())
        return {};
    const auto kept = std::span(pages_[page_]).subspan(used_, count);
    used_ += count;
    return kept;
}

} // namespace app

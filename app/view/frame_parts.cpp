// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/frame_parts.h"

namespace app {

void FrameParts::put(const ClipResult& clipped)
{
    const std::scoped_lock lock(lock_);
    clipped_ = clipped;
}

void FrameParts::put(const FinishedBand& band)
{
    const std::scoped_lock lock(lock_);
    bands_.push_back(band);
}

std::optional<ClipResult> FrameParts::clipped() const
{
    const std::scoped_lock lock(lock_);
    return clipped_;
}

std::vector<FinishedBand> FrameParts::bands() const
{
    const std::scoped_lock lock(lock_);
    return bands_;
}

} // namespace app

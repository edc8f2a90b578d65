// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/objects.h"
#include "app/scene/region.h"

namespace app::svg {

/// How often lines of some objects may meet those of a clip path, one another, and those of the
/// clip path itself: a small file may have millions of such places. Few lines are not looked at.
class ClipMeetings {
public:
    ClipMeetings(const Objects& objects, const ClipRegion& region, double tolerance);

    bool areTooMany() const { return tooMany_; }
    std::size_t chords() const { return chords_; } ///< of all objects
    std::size_t edges() const { return edges_; }   ///< of the clip path

private:
    std::size_t chords_ = 0, edges_ = 0;
    bool tooMany_ = false;
};

} // namespace app::svg

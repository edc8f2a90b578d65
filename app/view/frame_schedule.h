// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/frame_wish.h"

#include <cstdint>
#include <optional>

namespace app {

/// Decides which frame is painted next while other frames are wanted faster than they can be
/// painted. At most one frame is painted at a time; the caller paints it, and shows the last
/// finished one until the next one is finished.
///
/// 1. A frame of another drawing or size is of no use: it is cancelled for the wanted one. The next
///    one then is not, so that changes that come all the time do not keep any frame from being
///    finished.
/// 2. Any other frame is finished first: cancelling it at each move of the mouse would starve the
///    picture. Of the frames that wait, the newest one is next.
/// 3. When no other frame has been wanted for half a second, nothing starves any more: a frame that
///    is out of date is cancelled.
/// 4. A rough frame that is still wanted then is painted once more, finely, which may take long:
///    for any other frame this is cancelled.
class FrameSchedule {
public:
    /// What the caller must do now.
    enum class Step : std::uint8_t {
        Nothing,
        Start,   ///< painting the wanted frame
        Replace, ///< cancel the painting, and start painting the wanted frame
        Cancel   ///< the painting: the wanted frame is finished already
    };

    Step want(const FrameKey& key); ///< at each event that asks for a frame
    Step rested();                  ///< no other frame has been wanted for half a second
    Step finished(bool rough);      ///< the painting
    void forget();                  ///< nothing is wanted, finished or painted any more

    /// The frame that is being painted; the last finished one.
    const std::optional<FrameKey>& painting() const { return painting_; }
    const std::optional<FrameKey>& shown() const { return shown_; }
    bool isCurrent() const { return wanted_ == shown_; } ///< the wanted frame is finished
    /// Another frame than the wanted one is being painted.
    bool isLate() const { return painting_ && painting_ != wanted_; }
    /// The wanted frame is finished, but only roughly.
    bool isRough() const { return isCurrent() && rough_; }
    /// The frame that is being painted must not be rough.
    bool paintsFinely() const { return fine_; }

private:
    Step start(Step step);

    std::optional<FrameKey> wanted_, painting_, shown_;
    bool rough_ = false, fine_ = false;
    bool spares_ = false; ///< the last painting was cancelled, so the next one is not
};

} // namespace app

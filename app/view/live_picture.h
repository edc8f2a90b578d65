// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/background.h"
#include "app/view/frame_painting.h"
#include "app/view/frame_schedule.h"
#include "app/view/frame_times.h"

#include <QElapsedTimer>
#include <QTimer>

class QPainter;

namespace app {

/// The picture of a view that changes faster than it can be painted. All clipping and painting is
/// done on other threads: whatever a frame takes, the view's thread waits at most as long as it
/// allows. Meanwhile the last picture is there, moved and scaled, and above it what is finished of
/// the frame that is being painted (FrameSchedule), if it differs in more than its cut or frames
/// take long.
class LivePicture : public QObject {
    Q_OBJECT

public:
    static constexpr double longWait = 300; ///< milliseconds without any part of the next cut

    explicit LivePicture(QObject* parent = nullptr);

    /// The frame that the view shows now; to be called whenever the view is painted. All lines are
    /// clipped each time, also if the picture is there already. Waits for the picture up to
    /// `patience`, unless the last one took far longer.
    void want(FrameWish wish, std::chrono::microseconds patience);

    /// Paints the picture as far as it is finished, moved and scaled to the wanted view.
    void paint(QPainter& painter) const;
    /// The last finished frame and its key; null: there is none.
    const PaintedFrame& frame() const { return frame_; }
    const FrameKey* key() const { return schedule_.shown() ? &*schedule_.shown() : nullptr; }
    FrameTimes times() const;

    void settle(); ///< waits until the wanted frame is finished and its lines are clipped
    void forget(); ///< all pictures, for example because another drawing was opened

signals:             // none of them while want() waits
    void advanced(); ///< more of the picture is finished
    void timed();    ///< there are other times

private:
    void follow(FrameSchedule::Step step);
    void start();
    void deliver(PaintedFrame frame);
    void noteParts();
    void clip();
    void note(const FrameKey& key, const ClipResult& result);
    void noteLateness();
    QRectF placeOf(const FrameKey& key) const;
    bool showsParts() const;

    FrameWish wish_; ///< the newest one
    FrameSchedule schedule_;
    PaintedFrame frame_; ///< that is shown
    QTimer rest_;        ///< runs out when no other frame has been wanted for a while
    /// Since another frame than frame_ was wanted, and than that which is being painted.
    QElapsedTimer late_, left_;
    QTimer telling_; ///< of times() while frame_ is late

    Background<PaintedFrame> painting_;
    std::shared_ptr<FramePainter> painter_ = std::make_shared<FramePainter>();
    std::shared_ptr<FrameParts> parts_; ///< of the frame that is being painted
    bool partsNoted_ = false;           ///< its clipping is

    Background<ClipResult> clipping_; ///< of frames that are not painted, or not yet
    std::shared_ptr<FramePainter> clipper_ = std::make_shared<FramePainter>();
    bool clipsAgain_ = false; ///< another clipping was wanted meanwhile

    FrameKey clipped_; ///< the last frame whose lines were clipped
    FrameTimes times_;
};

} // namespace app

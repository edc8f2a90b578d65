// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/live_picture.h"

#include <QPainter>
#include <QSignalBlocker>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

using namespace std::chrono_literals;
using Step = FrameSchedule::Step;

constexpr auto rest = 500ms, told = 250ms;
constexpr double tooLong = 40; // milliseconds; after such a picture waiting for the next is in vain

} // namespace

LivePicture::LivePicture(QObject* parent) : QObject(parent), painting_(paintingThreads())
{
    rest_.setSingleShot(true);
    rest_.setInterval(rest);
    telling_.setInterval(told);
    connect(&telling_, &QTimer::timeout, this, &LivePicture::timed);
    connect(&rest_, &QTimer::timeout, this, [this] { follow(schedule_.rested()); });
}

void LivePicture::want(FrameWish wish, std::chrono::microseconds patience)
{
    const QSignalBlocker quiet(this);
    const bool isNew = wish.key != wish_.key;
    wish_ = std::move(wish);
    const Step step = schedule_.want(wish_.key);
    follow(step);
    if (step != Step::Start && step != Step::Replace)
        clip();
    else if (frame_.drawMs < tooLong)
        painting_.waitFor(patience);
    noteLateness();
    if (isNew && (schedule_.isLate() || schedule_.isRough()))
        rest_.start();
}

void LivePicture::follow(Step step)
{
    if (step == Step::Start || step == Step::Replace)
        return start(); // which cancels what is being painted
    if (step != Step::Cancel)
        return;
    painting_.cancel();
    parts_.reset();
}

void LivePicture::start()
{
    clipping_.cancel(); // of an earlier frame: its times would come after those of this one
    clipsAgain_ = false;
    parts_ = std::make_shared<FrameParts>();
    partsNoted_ = false;
    // In a view that was not panned only, a rough frame would not be finished sooner.
    const auto& shown = schedule_.shown();
    wish_.rough =
        !schedule_.paintsFinely() && shown && wholePixelsBetween(*shown, wish_.key).has_value();
    painting_.start([wish = wish_, painter = painter_, parts = parts_](
                        const Follower& follower) { return painter->paint(wish, follower, parts); },
                    [this](PaintedFrame frame) { deliver(std::move(frame)); },
                    [this](const Progress&) {
                        noteParts();
                        if (!parts_->bands().empty())
                            emit advanced();
                    });
}

void LivePicture::deliver(PaintedFrame frame)
{
    noteParts();
    parts_.reset();
    frame_ = std::move(frame);
    times_.drawMs = frame_.drawMs;
    times_.differing = frame_.differing;
    late_ = left_;
    follow(schedule_.finished(frame_.rough));
    noteLateness();
    if (schedule_.isRough())
        rest_.start();
    emit advanced();
}

/// The frame that is being painted may be clipped by now.
void LivePicture::noteParts()
{
    if (partsNoted_)
        return;
    const auto clipped = parts_->clipped();
    if (clipped)
        note(*schedule_.painting(), *clipped);
    partsNoted_ = clipped.has_value();
}

void LivePicture::clip()
{
    clipsAgain_ = clipping_.active();
    if (clipsAgain_)
        return;
    clipping_.start([wish = wish_, clipper = clipper_](
                        const Follower& follower) { return clipper->clip(wish, follower.stop); },
                    [this, key = wish_.key](const ClipResult& result) {
                        note(key, result);
                        if (clipsAgain_)
                            clip();
                    });
}

void LivePicture::note(const FrameKey& key, const ClipResult& result)
{
    if (times_.clipping == 0 || !isSameClipping(key, clipped_))
        times_.subject = newSubject();
    ++times_.clipping;
    clipped_ = key;
    times_.clipMs = double(result.nanoseconds) * 1e-6;
    times_.visible = result.visible;
    times_.total = result.total;
    times_.choice = key.variant;
    emit timed();
}

FrameTimes LivePicture::times() const
{
    FrameTimes times = times_;
    times.painting = !schedule_.isCurrent();
    const auto& shown = schedule_.shown();
    const bool isOnlyCut = shown && isSameView(*shown, wish_.key);
    times.lateMs = times.painting && isOnlyCut && late_.isValid() ? double(late_.elapsed()) : 0;
    return times;
}

/// To be called after each change of what is wanted, painted or shown.
void LivePicture::noteLateness()
{
    const auto run = [](QElapsedTimer& clock, bool runs) {
        if (!runs)
            clock.invalidate();
        else if (!clock.isValid())
            clock.start();
    };
    run(late_, !schedule_.isCurrent());
    run(left_, schedule_.isLate());
    if (schedule_.isCurrent())
        telling_.stop();
    else if (!telling_.isActive())
        telling_.start();
}

void LivePicture::settle()
{
    do {
        follow(schedule_.rested());
        painting_.wait();
        clipping_.wait();
    } while (painting_.active() || clipping_.active() || schedule_.isRough());
}

void LivePicture::forget()
{
    painting_.cancel();
    clipping_.cancel();
    rest_.stop();
    parts_.reset();
    schedule_.forget();
    late_.invalidate();
    left_.invalidate();
    telling_.stop();
    wish_ = {};
    frame_ = {};
    clipped_ = {};
    times_ = {.clipping = times_.clipping, .subject = newSubject()};
}

/// The rectangle that a frame covers in the wanted view, in logical pixels.
QRectF LivePicture::placeOf(const FrameKey& key) const
{
    const View &now = wish_.key.view, &then = key.view;
    if (then == now)
        return {0, 0, now.size.x, now.size.y};
    const clipping::Window seen = then.visible();
    const Point from = now.toScreen(seen.min), to = now.toScreen(seen.max);
    if (then.zoom != now.zoom)
        return {from.x, from.y, to.x - from.x, to.y - from.y};
    const double ratio = key.pixelRatio; // whole device pixels are copied, parts of them blended
    return {std::round(from.x * ratio) / ratio, std::round(from.y * ratio) / ratio, then.size.x,
            then.size.y};
}

/// Whether the finished bands of the frame that is being painted are shown above the last frame. If
/// only the windows differ, the picture would show two cuts and the outline of one; it does so only
/// where frames take long. What was made of the last frame cannot be shown in part.
bool LivePicture::showsParts() const
{
    const auto &last = schedule_.shown(), &next = schedule_.painting();
    const bool isOnlyCut =
        last && next && isSameView(*last, *next) && !(last->region == next->region);
    return parts_ && next && !frame_.made && (!isOnlyCut || frame_.drawMs > longWait);
}

/// Whether the device pixels of a rectangle have coordinates that an int holds.
static bool hasPixels(const QRectF& r, double ratio)
{
    constexpr double most = 1 << 24;
    return std::max(
               {std::abs(r.left()), std::abs(r.top()), std::abs(r.right()), std::abs(r.bottom())})
               * ratio
           < most;
}

void LivePicture::paint(QPainter& painter) const
{
    const double ratio = wish_.key.pixelRatio;
    const auto inPixels = [ratio](const QRectF& r) { // so that bands join without a gap
        const QPoint from(qRound(r.left() * ratio), qRound(r.top() * ratio));
        return QRect(from, QPoint(qRound(r.right() * ratio) - 1, qRound(r.bottom() * ratio) - 1));
    };
    const auto inPoints = [ratio](const QRect& r) {
        return QRectF(r.x() / ratio, r.y() / ratio, r.width() / ratio, r.height() / ratio);
    };
    QRegion rest(inPixels(painter.viewport()));
    if (showsParts()) {
        const FrameKey& key = *schedule_.painting();
        const QRectF place = placeOf(key);
        const double scale = place.height() / key.pixels.height();
        for (const auto& [band, image] : parts_->bands()) {
            const QRectF where(place.left(), place.top() + band.top * scale, place.width(),
                               band.height * scale);
            if (!hasPixels(where, ratio)) // the view has gone far since the band was painted
                continue;
            const QRect at = inPixels(where);
            painter.drawImage(inPoints(at), image);
            rest -= at;
        }
    }
    const FrameKey* const shown = key();
    if (!shown || frame_.image.isNull())
        return;
    // At a clip of many rectangles QPainter takes ten times as long to scale.
    for (const QRect& part : rest) {
        painter.save();
        painter.setClipRect(inPoints(part), Qt::IntersectClip);
        painter.drawImage(placeOf(*shown), frame_.image);
        painter.restore();
    }
}

} // namespace app

#include "moc_live_picture.cpp"

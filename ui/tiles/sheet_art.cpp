// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tiles/sheet_art.h"

#include <QDeadlineTimer>

#include <algorithm>
#include <cmath>

namespace ui {
namespace {

constexpr int mostWaiting = 5; // milliseconds

app::Colour colourOf(const QColor& c)
{
    return {std::uint8_t(c.red()), std::uint8_t(c.green()), std::uint8_t(c.blue())};
}

bool same(const SheetWish& a, const SheetWish& b)
{
    return a.sheet == b.sheet && a.view == b.view && a.region == b.region;
}

} // namespace

SheetArt::SheetArt(app::Session& session, app::LiveSheets& sheets)
    : session_(session), sheets_(sheets), painting_(app::paintingThreads())
{
}

void SheetArt::want(std::vector<SheetWish> wishes, std::uint64_t revision, const Look& look,
                    double pixelRatio)
{
    const bool isAlike = revision == revision_ && &look == look_ && pixelRatio == pixelRatio_;
    if (isAlike && std::ranges::equal(wishes, wanted_, same))
        return;
    revision_ = revision;
    look_ = &look;
    pixelRatio_ = pixelRatio;
    std::erase_if(pictures_, [&](const Picture& old) {
        return std::ranges::find(wishes, old.sheet, &SheetWish::sheet) == wishes.end();
    });
    wanted_ = std::move(wishes);
    left_ = {wanted_.begin(), wanted_.end()};
    // What is being painted is finished, and the next sheet begins; otherwise views that change all
    // the time would starve the pictures.
    if (const auto last = std::ranges::find(left_, painted_.sheet, &SheetWish::sheet);
        last != left_.end())
        std::ranges::rotate(left_, last + 1);
    if (!isAlike)
        painting_.cancel();
    times_ = {.clipping = times_.clipping + 1, .subject = app::newSubject()};
    times_.total = sheets_.scene().lines().size();
    times_.choice = session_.cuts();
    if (!painting_.active())
        paintNext();
    for (QDeadlineTimer end(mostWaiting); painting_.active() && !end.hasExpired();)
        painting_.waitFor(std::chrono::milliseconds(end.remainingTime()));
}

app::FrameWish SheetArt::frameOf(const SheetWish& wish) const
{
    const app::SceneLines& lines = sheets_.scene().lines();
    const app::Point size = wish.view.size * pixelRatio_;
    app::FrameWish frame{.key = {.lines = lines.revision(),
                                 .view = wish.view,
                                 .region = wish.region,
                                 .variant = session_.cuts(),
                                 .pixels = {int(std::ceil(size.x)), int(std::ceil(size.y))},
                                 .pixelRatio = pixelRatio_},
                         .document = sheets_.drawing(),
                         .lines = lines,
                         .ghost = look_->ghost};
    frame.underlays = seenUnderlays(frame.document);
    frame.key.images = images_.follow(frame.underlays);
    frame.options.removed = wish.removed;
    if (look_->dark)
        frame.options.page = colourOf(look_->paper);
    frame.options.leastWidth = pixelRatio_ < 1.5 ? 0.75 : 0.5;
    return frame;
}

void SheetArt::paintNext()
{
    if (left_.empty())
        return wanted_.empty() ? void() : emit frameShown(times_);
    const auto parts = std::make_shared<app::FrameParts>();
    painted_ = left_.front();
    painting_.start(
        [wish = frameOf(painted_), painter = painter_, parts](const app::Follower& follower) {
            return painter->paint(wish, follower, parts);
        },
        [this, parts](app::PaintedFrame frame) {
            accept(parts->clipped().value(), std::move(frame));
        });
}

void SheetArt::accept(const app::ClipResult& clipped, app::PaintedFrame frame)
{
    times_.clipMs += double(clipped.nanoseconds) * 1e-6;
    times_.drawMs += frame.drawMs;
    times_.visible += clipped.visible;
    std::erase_if(left_, [this](const SheetWish& wish) { return same(wish, painted_); });
    std::erase_if(pictures_, [this](const Picture& old) { return old.sheet == painted_.sheet; });
    pictures_.push_back({painted_.sheet, painted_.view.visible(), std::move(frame.image)});
    emit painted();
    paintNext();
}

void SheetArt::settle()
{
    while (painting_.active()) // each picture starts the next one
        painting_.wait();
}

void SheetArt::forget()
{
    painting_.cancel();
    left_.clear();
    wanted_.clear();
    pictures_.clear();
}

} // namespace ui

#include "moc_sheet_art.cpp"

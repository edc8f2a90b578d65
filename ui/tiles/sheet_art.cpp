// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tiles/sheet_art.h"

#include "app/view/raster.h"

#include <QElapsedTimer>

#include <algorithm>

namespace ui {
namespace {

constexpr int atOnceMs = 30, sliceMs = 20;
constexpr std::size_t mostPointsAtOnce = 60'000; // painted in some hundredths of a second

app::Colour colourOf(const QColor& c)
{
    return {std::uint8_t(c.red()), std::uint8_t(c.green()), std::uint8_t(c.blue())};
}

bool same(const std::vector<SheetWish>& a, const std::vector<SheetWish>& b)
{
    return std::ranges::equal(a, b, [](const SheetWish& one, const SheetWish& other) {
        return one.sheet == other.sheet && one.view == other.view && one.region == other.region;
    });
}

QImage rasterised(const app::Picture& picture, const app::View& view, double ratio, double ghost)
{
    const int width = int(std::ceil(view.size.x * ratio));
    const int height = int(std::ceil(view.size.y * ratio));
    return app::rasterised(picture, {0, height}, {width, ratio, ghost});
}

} // namespace

SheetArt::SheetArt(app::Session& session, app::LiveSheets& sheets)
    : session_(session), sheets_(sheets)
{
    next_.setSingleShot(true);
    connect(&next_, &QTimer::timeout, this, [this] { work(sliceMs); });
}

void SheetArt::want(std::vector<SheetWish> wishes, std::uint64_t revision, const Look& look,
                    double pixelRatio)
{
    if (revision == revision_ && &look == look_ && pixelRatio == pixelRatio_
        && same(wishes, wanted_))
        return;
    revision_ = revision;
    look_ = &look;
    pixelRatio_ = pixelRatio;
    std::erase_if(pictures_, [&](const Picture& old) {
        return std::ranges::find(wishes, old.sheet, &SheetWish::sheet) == wishes.end();
    });
    wanted_ = std::move(wishes);
    left_ = {wanted_.begin(), wanted_.end()};
    painter_.cancel();
    times_ = {};
    times_.total = sheets_.scene().lines().size();
    times_.choice = session_.variant();
    work(atOnceMs);
}

void SheetArt::work(int milliseconds)
{
    QElapsedTimer clock;
    clock.start();
    while (!left_.empty() && !painter_.active() && clock.elapsed() < milliseconds)
        paintNext();
    if (!left_.empty() && !painter_.active())
        next_.start(0);
    if (left_.empty() && !wanted_.empty())
        emit frameShown(times_);
}

/// A frame of the scene is valid until the next one is clipped: its picture is made at once.
app::Picture SheetArt::picture(const SheetWish& wish)
{
    app::Scene& scene = sheets_.scene();
    const app::SceneFrame frame = scene.clip(wish.region, session_.variant());
    times_.clipMs += double(frame.nanoseconds) * 1e-6;
    times_.visible += frame.visible;
    app::PictureOptions options;
    options.view = wish.view;
    options.removed = wish.removed;
    options.region = &wish.region;
    if (look_->dark)
        options.page = colourOf(look_->paper);
    options.leastWidth = pixelRatio_ < 1.5 ? 0.75 : 0.5;
    return app::picture(sheets_.drawing().styles(), scene.lines(), frame, options);
}

void SheetArt::paintNext()
{
    QElapsedTimer clock;
    clock.start();
    const double clippedBefore = times_.clipMs;
    const SheetWish wish = std::move(left_.front());
    auto art = std::make_shared<app::Picture>(picture(wish));
    if (art->kept.points.size() + art->ghost.points.size() <= mostPointsAtOnce) {
        accept(wish.sheet, wish.view, rasterised(*art, wish.view, pixelRatio_, look_->ghost));
        times_.drawMs += double(clock.nsecsElapsed()) * 1e-6 - (times_.clipMs - clippedBefore);
        return;
    }
    painter_.start([art, view = wish.view, ratio = pixelRatio_, ghost = look_->ghost](
                       const app::Follower&) { return rasterised(*art, view, ratio, ghost); },
                   [this, clock, view = wish.view, sheet = wish.sheet](QImage image) {
                       times_.drawMs += double(clock.nsecsElapsed()) * 1e-6;
                       accept(sheet, view, std::move(image));
                       work(sliceMs);
                   });
}

void SheetArt::accept(std::size_t sheet, const app::View& view, QImage image)
{
    left_.pop_front();
    std::erase_if(pictures_, [sheet](const Picture& old) { return old.sheet == sheet; });
    pictures_.push_back({sheet, view.visible(), std::move(image)});
    emit painted();
}

void SheetArt::settle()
{
    while (!left_.empty())
        if (painter_.active())
            painter_.wait();
        else
            work(sliceMs);
}

void SheetArt::forget()
{
    painter_.cancel();
    left_.clear();
    wanted_.clear();
    pictures_.clear();
}

} // namespace ui

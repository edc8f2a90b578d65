// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/explanation/drawn_pictures.h"

#include "app/session/manual_picture.h"
#include "ui/look/look.h"

#include <algorithm>

namespace ui {

namespace {

constexpr std::size_t mostKept = 6; // more than a page has: the page asks again for each

/// The paper is white in both themes.
const Look& paperLook() { return lookOnPaper(false); }

app::ThumbnailColours colours()
{
    return {paperLook().paper, paperLook().accent, paperLook().ghost};
}

app::DiscLook discs(const Look& page)
{
    return {paperLook().text, paperLook().paper, page.border, QApplication::font()};
}

} // namespace

QImage DrawnPictures::now(const QString& address, int width, double pixelRatio)
{
    const auto picture = app::manualPicture(address);
    return picture ? app::painted(*picture, app::manualPictureSize(width), pixelRatio, colours(),
                                  discs(paperLook()))
                   : QImage();
}

QImage DrawnPictures::picture(const QString& address, int width, double pixelRatio,
                              const Look& look)
{
    const auto isOf = [&](const Kept& one) {
        return one.address == address && one.width == width && one.pixelRatio == pixelRatio
               && one.look == &look;
    };
    if (const auto found = std::ranges::find_if(kept_, isOf); found != kept_.end())
        return found->image;
    const auto picture = app::manualPicture(address);
    const QSize points = app::manualPictureSize(width);
    QImage empty(points * pixelRatio, QImage::Format_RGB32);
    if (!picture || empty.isNull())
        return {};
    empty.setDevicePixelRatio(pixelRatio);
    empty.fill(paperLook().paper);
    if (work_.active() && isOf(wanted_))
        return empty;
    wanted_ = {address, width, pixelRatio, &look};
    work_.start(
        [picture = *picture, points, pixelRatio, colours = colours(),
         discs = discs(look)](const app::Follower&) {
            return app::painted(picture, points, pixelRatio, colours, discs);
        },
        [this](QImage image) {
            kept_.push_back(wanted_);
            kept_.back().image = std::move(image);
            if (kept_.size() > mostKept)
                kept_.pop_front();
            emit drawn();
        });
    return empty;
}

} // namespace ui

#include "moc_drawn_pictures.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/explanation/drawn_pictures.h"

#include "app/session/manual_picture.h"
#include "ui/look/look.h"

namespace ui {

namespace {

/// The paper is white in both themes.
const Look& paperLook() { return lookOnPaper(false); }

app::ThumbnailColours colours()
{
    return {paperLook().paper, paperLook().accent, paperLook().ghost};
}

app::DiscLook discs() { return {paperLook().text, paperLook().paper, QApplication::font()}; }

} // namespace

QImage DrawnPictures::now(const QString& address, int width, double pixelRatio)
{
    const auto picture = app::manualPicture(address);
    return picture ? app::painted(*picture, app::manualPictureSize(width), pixelRatio, colours(),
                                  discs())
                   : QImage();
}

QImage DrawnPictures::picture(const QString& address, int width, double pixelRatio)
{
    const auto isOf = [&](const Kept& one) {
        return one.address == address && one.width == width && one.pixelRatio == pixelRatio;
    };
    if (isOf(kept_))
        return kept_.image;
    const auto picture = app::manualPicture(address);
    const QSize points = app::manualPictureSize(width);
    QImage empty(points * pixelRatio, QImage::Format_RGB32);
    if (!picture || empty.isNull())
        return {};
    empty.setDevicePixelRatio(pixelRatio);
    empty.fill(paperLook().paper);
    if (work_.active() && isOf(wanted_))
        return empty;
    wanted_ = {address, width, pixelRatio};
    work_.start(
        [picture = *picture, points, pixelRatio, colours = colours(),
         discs = discs()](const app::Follower&) {
            return app::painted(picture, points, pixelRatio, colours, discs);
        },
        [this](QImage image) {
            kept_ = wanted_;
            kept_.image = std::move(image);
            emit drawn();
        });
    return empty;
}

} // namespace ui

#include "moc_drawn_pictures.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/leftover_picture.h"

#include "app/view/thumbnail.h"
#include "ui/look/look.h"
#include "ui/look/text.h"

#include <QPainter>

namespace ui {

namespace {

constexpr QSize pictureSize(240, 170);

} // namespace

LeftoverPicture::LeftoverPicture(QWidget* parent) : QFrame(parent)
{
    setFixedSize(pictureSize);
    setAccessibleName(Text::tr("Picture of the drawing"));
}

void LeftoverPicture::showPicture(const app::Leftover& leftover)
{
    const Look& look = lookOnPaper(false);
    const app::ThumbnailColours colours{look.paper, look.accent, look.ghost};
    picture_ = {};
    sentence_ = Text::tr("Reading…");
    update();
    background_.start(
        [leftover, colours, size = size(), ratio = devicePixelRatioF()](const app::Follower&) {
            const auto found = app::recover(leftover);
            return found ? app::thumbnail(found.value->document, size, ratio, colours) : QImage();
        },
        [this](const QImage& picture) {
            picture_ = picture;
            sentence_ = picture.isNull() ? Text::tr("No picture") : QString();
            update();
        });
}

void LeftoverPicture::paintEvent(QPaintEvent*)
{
    const Look& look = lookOnPaper(false);
    QPainter painter(this);
    painter.fillRect(rect(), look.paper);
    if (!picture_.isNull())
        painter.drawImage(rect(), picture_);
    painter.setPen(look.muted);
    painter.drawText(rect(), Qt::AlignCenter, sentence_);
    painter.setPen(look.border);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

} // namespace ui

#include "moc_leftover_picture.cpp"

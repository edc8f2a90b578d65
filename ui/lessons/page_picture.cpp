// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/page_picture.h"

#include "app/base/background.h"
#include "app/session/samples.h"
#include "ui/look/look.h"
#include "ui/look/text.h"

#include <QFileInfo>
#include <QImageReader>
#include <QPainter>
#include <QPromise>
#include <QThreadPool>

#include <algorithm>
#include <memory>

namespace ui {

namespace {

constexpr QSize usualSize(384, 216);
constexpr int rest = 60; // milliseconds without a change of size

/// A picture of a lesson's own in the middle of white paper; runs on another thread.
QImage filePicture(const QString& file, const QSize& size)
{
    QImage paper(size, QImage::Format_RGB32);
    paper.fill(Qt::white);
    if (!QFileInfo(file).isFile()) // a pipe would never end
        return paper;
    QImageReader reader(file, "png");
    reader.setScaledSize(reader.size().scaled(size, Qt::KeepAspectRatio));
    const QImage picture = reader.read();
    QPainter(&paper).drawImage((size.width() - picture.width()) / 2,
                               (size.height() - picture.height()) / 2, picture);
    return paper;
}

} // namespace

PagePicture::PagePicture(QWidget* parent) : QWidget(parent)
{
    QSizePolicy policy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    policy.setHeightForWidth(true);
    setSizePolicy(policy);
    later_.setSingleShot(true);
    later_.setInterval(rest);
    connect(&later_, &QTimer::timeout, this, &PagePicture::start);
    connect(&watcher_, &QFutureWatcherBase::resultReadyAt, this, [this](int i) {
        picture_ = watcher_.resultAt(i);
        update();
    });
    hide();
}

PagePicture::~PagePicture() { watcher_.cancel(); }

void PagePicture::show(const QString& picture)
{
    const auto all = app::samples();
    const auto found = std::ranges::find(all, picture, &app::Sample::key);
    const bool isSample = found != all.end(), isShown = isSample || picture.contains(u'/');
    setVisible(isShown);
    if (!isShown || shown_ == picture)
        return;
    shown_ = picture;
    picture_ = {};
    file_ = isSample ? found->file : picture;
    setAccessibleName(isSample ? Text::tr("Picture: %1, with a clip window").arg(found->title)
                               : Text::tr("Picture: %1").arg(QFileInfo(picture).fileName()));
    later_.start();
}

/// Paints the picture in the widget's size.
void PagePicture::start()
{
    if (file_.isEmpty() || size().isEmpty())
        return;
    auto promise = std::make_shared<QPromise<QImage>>();
    promise->start();
    watcher_.cancel();
    watcher_.setFuture(promise->future());
    const Look& look = lookOnPaper(false);
    const app::ThumbnailColours colours{look.paper, look.accent, look.ghost};
    app::paintingThreads().start([=, file = file_, points = size(), ratio = devicePixelRatioF()] {
        if (!promise->isCanceled())
            promise->addResult(file.startsWith(u':')
                                   ? app::samplePicture(file, points, ratio, colours)
                                   : filePicture(file, points * ratio));
        promise->finish();
    });
}

int PagePicture::heightForWidth(int width) const
{
    return width * usualSize.height() / usualSize.width();
}

QSize PagePicture::sizeHint() const { return usualSize; }

void PagePicture::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    later_.start();
}

void PagePicture::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(rect(), lookOnPaper(false).paper);
    if (!picture_.isNull())
        painter.drawImage(rect(), picture_);
    painter.setPen(lookOf(palette()).border);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

} // namespace ui

#include "moc_page_picture.cpp"

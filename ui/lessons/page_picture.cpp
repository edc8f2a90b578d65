// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/page_picture.h"

#include "app/base/background.h"
#include "app/session/samples.h"
#include "ui/look/look.h"
#include "ui/look/text.h"

#include <QPainter>
#include <QPromise>
#include <QThreadPool>

#include <algorithm>
#include <memory>

namespace ui {

namespace {

constexpr QSize usualSize(384, 216);
constexpr int rest = 60; // milliseconds without a change of size

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

void PagePicture::show(const QString& sample)
{
    const auto all = app::samples();
    const auto found = std::ranges::find(all, sample, &app::Sample::key);
    setVisible(found != all.end());
    if (found == all.end() || sample_ == sample)
        return;
    sample_ = sample;
    picture_ = {};
    file_ = found->file;
    setAccessibleName(Text::tr("Picture: %1, with a clip window").arg(found->title));
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
            promise->addResult(app::samplePicture(file, points, ratio, colours));
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

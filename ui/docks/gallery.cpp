// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/gallery.h"

#include "app/base/background.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/buttons.h"

#include <QEvent>
#include <QPromise>
#include <QResizeEvent>
#include <QThreadPool>

#include <atomic>
#include <memory>

namespace ui {

namespace {

constexpr int columns = 2, gap = 10;

constexpr int behindTheCanvas = -1; // priority in the thread pool; the default is 0

// A job that renders all pictures in one size. The rendering threads share its ownership and do not
// use widgets.
struct Sitting {
    QPromise<QImage> promise; ///< finished with the last picture, or cancelled
    std::atomic<int> left;
};

} // namespace

Gallery::Gallery(QWidget* parent) : QWidget(parent), samples_(app::samples())
{
    setAccessibleName(Text::tr("Samples"));
    connect(&watcher_, &QFutureWatcherBase::resultReadyAt, this,
            [this](int i) { buttons_[std::size_t(i)]->setPicture(watcher_.resultAt(i)); });
    for (const app::Sample& sample : samples_) {
        auto* button = new SampleButton(sample.title, this);
        buttons_.push_back(button);
        connect(button, &QAbstractButton::clicked, this, [this, &sample] { emit chosen(sample); });
    }
}

Gallery::~Gallery() { watcher_.cancel(); }

void Gallery::mark(const QString& key)
{
    for (std::size_t i = 0; i < samples_.size(); ++i)
        buttons_[i]->setMarked(samples_[i].key == key);
}

void Gallery::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (painted_ != buttons_.front()->pictureSize())
        paintPictures();
}

void Gallery::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    const int each = (width() - gap * (columns - 1)) / columns;
    const int high = SampleButton::heightFor(each);
    for (int i = 0; i < int(buttons_.size()); ++i)
        buttons_[std::size_t(i)]->setGeometry(i % columns * (each + gap),
                                              i / columns * (high + gap), each, high);
    setFixedHeight((int(buttons_.size()) + columns - 1) / columns * (high + gap));
    if (isVisible() && painted_ != buttons_.front()->pictureSize())
        paintPictures();
}

void Gallery::paintPictures()
{
    if (buttons_.empty())
        return;
    const Look& look = lookOnPaper(false);
    const app::ThumbnailColours colours{look.paper, look.accent, look.ghost};
    const QSize points = painted_ = buttons_.front()->pictureSize();
    auto sitting = std::make_shared<Sitting>();
    sitting->left = int(samples_.size());
    sitting->promise.start();
    watcher_.cancel();
    watcher_.setFuture(sitting->promise.future());
    for (std::size_t i = 0; i < samples_.size(); ++i)
        app::paintingThreads().start(
            [=, file = samples_[i].file, ratio = devicePixelRatioF()] {
                if (!sitting->promise.isCanceled())
                    sitting->promise.addResult(app::samplePicture(file, points, ratio, colours),
                                               int(i));
                if (--sitting->left == 0)
                    sitting->promise.finish();
            },
            behindTheCanvas);
}

} // namespace ui

#include "moc_gallery.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/gallery.h"

#include "app/view/thumbnail.h"
#include "ui/look.h"
#include "ui/widgets/sample_button.h"

#include <QEvent>
#include <QResizeEvent>
#include <QThread>

namespace ui {

namespace {

constexpr int columns = 2, gap = 10;

QImage pictureOf(const app::Sample& sample, const QSize& points, double ratio,
                 const app::ThumbnailColours& colours)
{
    const auto imported = app::readFile(sample.file);
    return imported ? app::thumbnail(imported.value->sheet, points, ratio, colours) : QImage();
}

} // namespace

Gallery::Gallery(QWidget* parent) : QWidget(parent), samples_(app::samples())
{
    setAccessibleName(tr("Samples"));
    for (const app::Sample& sample : samples_) {
        auto* button = new SampleButton(sample.title, this);
        buttons_.push_back(button);
        connect(button, &QAbstractButton::clicked, this, [this, &sample] { emit chosen(sample); });
    }
}

Gallery::~Gallery()
{
    ++generation_;
    for (QThread* painter : findChildren<QThread*>()) // ends after the picture that it is at
        painter->wait();
}

void Gallery::mark(const QString& key)
{
    for (std::size_t i = 0; i < samples_.size(); ++i)
        buttons_[i]->setMarked(samples_[i].key == key);
}

void Gallery::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (generation_ == 0)
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
    if (isVisible() && event->oldSize().width() != width())
        paintPictures();
}

void Gallery::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && generation_ > 0)
        paintPictures();
}

void Gallery::paintPictures()
{
    if (buttons_.empty())
        return;
    const int generation = ++generation_;
    const Look& look = lookOf(palette());
    const app::ThumbnailColours colours{look.paper, look.accent, look.ghost};
    // The thread touches nothing of this widget but the counter and its list of events.
    auto* painter =
        QThread::create([this, samples = samples_, points = buttons_.front()->pictureSize(),
                         colours, generation, ratio = devicePixelRatioF()] {
            for (std::size_t i = 0; i < samples.size() && generation_ == generation; ++i) {
                const QImage image = pictureOf(samples[i], points, ratio, colours);
                QMetaObject::invokeMethod(this, [this, generation, i, image] {
                    if (generation_ == generation)
                        buttons_[i]->setPicture(image);
                });
            }
        });
    painter->setParent(this);
    connect(painter, &QThread::finished, painter, &QObject::deleteLater);
    painter->start(QThread::LowPriority);
}

} // namespace ui

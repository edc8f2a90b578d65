// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/clipper_box.h"

#include "ui/widgets/algorithm_marker.h"

#include <QEvent>
#include <QPainter>
#include <QStandardItemModel>

#include <algorithm>

namespace ui {

namespace {

constexpr int markerSize = 12;

QPixmap marker(const app::Clipper& clipper, const QPalette& palette, double pixelRatio)
{
    QPixmap picture(QSize(markerSize + 2, markerSize + 2) * pixelRatio);
    picture.setDevicePixelRatio(pixelRatio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    app::paintMarker(painter, QRectF(1, 1, markerSize, markerSize), *clipper.algorithm,
                     clipper.form, groundOf(palette));
    return picture;
}

} // namespace

ClipperBox::ClipperBox(const QString& name, const QStringList& before, QWidget* parent)
    : ToolList(parent), all_(app::clippers()), before_(int(before.size()))
{
    setAccessibleName(name);
    setSizeAdjustPolicy(AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(12);
    setIconSize({markerSize + 2, markerSize + 2});
    setMaxVisibleItems(30);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    addItems(before);
    for (const app::Clipper& clipper : all_)
        addItem(app::titleOf(clipper));
    paintMarkers();
}

std::optional<app::Clipper> ClipperBox::clipper() const
{
    return currentIndex() < before_ ? std::nullopt
                                    : std::optional(all_[std::size_t(currentIndex() - before_)]);
}

int ClipperBox::rowOf(const app::Clipper& clipper) const
{
    return before_ + int(std::ranges::find(all_, clipper) - all_.begin());
}

void ClipperBox::choose(const app::Clipper& clipper) { setCurrentIndex(rowOf(clipper)); }

void ClipperBox::offer(const std::function<bool(const app::Clipper&)>& fits)
{
    const auto* items = qobject_cast<QStandardItemModel*>(model());
    for (const app::Clipper& clipper : all_)
        items->item(rowOf(clipper))->setEnabled(fits(clipper));
    if (!items->item(currentIndex())->isEnabled())
        setCurrentIndex(0);
}

void ClipperBox::paintMarkers()
{
    for (const app::Clipper& clipper : all_)
        setItemIcon(rowOf(clipper), marker(clipper, palette(), devicePixelRatioF()));
}

void ClipperBox::changeEvent(QEvent* event)
{
    ToolList::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        paintMarkers();
}

} // namespace ui

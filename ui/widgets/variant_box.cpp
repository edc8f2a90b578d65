// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/variant_box.h"

#include "ui/widgets/algorithm_marker.h"

#include <QEvent>
#include <QPainter>
#include <QStandardItemModel>

#include <algorithm>

namespace ui {

namespace {

constexpr int markerSize = 12;

QPixmap marker(const app::Variant& variant, const QPalette& palette, double pixelRatio)
{
    QPixmap picture(QSize(markerSize + 2, markerSize + 2) * pixelRatio);
    picture.setDevicePixelRatio(pixelRatio);
    picture.fill(Qt::transparent);
    QPainter painter(&picture);
    app::paintMarker(painter, QRectF(1, 1, markerSize, markerSize), variant, groundOf(palette));
    return picture;
}

} // namespace

VariantBox::VariantBox(const QString& name, const QStringList& before, QWidget* parent)
    : ToolList(parent), all_(app::variants()), before_(int(before.size()))
{
    setAccessibleName(name);
    setSizeAdjustPolicy(AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(12);
    setIconSize({markerSize + 2, markerSize + 2});
    setMaxVisibleItems(30);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    addItems(before);
    for (const app::Variant& variant : all_)
        addItem(app::titleOf(variant));
    paintMarkers();
}

std::optional<app::Variant> VariantBox::variant() const
{
    return currentIndex() < before_ ? std::nullopt
                                    : std::optional(all_[std::size_t(currentIndex() - before_)]);
}

int VariantBox::rowOf(const app::Variant& variant) const
{
    return before_ + int(std::ranges::find(all_, variant) - all_.begin());
}

void VariantBox::choose(const app::Variant& variant) { setCurrentIndex(rowOf(variant)); }

void VariantBox::offer(const std::function<bool(const app::Variant&)>& fits)
{
    const auto* items = qobject_cast<QStandardItemModel*>(model());
    for (const app::Variant& variant : all_)
        items->item(rowOf(variant))->setEnabled(fits(variant));
    if (!items->item(currentIndex())->isEnabled())
        setCurrentIndex(0);
}

void VariantBox::paintMarkers()
{
    for (const app::Variant& variant : all_)
        setItemIcon(rowOf(variant), marker(variant, palette(), devicePixelRatioF()));
}

void VariantBox::changeEvent(QEvent* event)
{
    ToolList::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        paintMarkers();
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/variant_box.h"

#include "ui/widgets/algorithm_marker.h"

#include <algorithm>

namespace ui {

VariantBox::VariantBox(const QString& name, const QStringList& before, QWidget* parent)
    : ToolList(parent), all_(app::variants()), before_(int(before.size()))
{
    setAccessibleName(name);
    setSizeAdjustPolicy(AdjustToMinimumContentsLengthWithIcon);
    setMinimumContentsLength(12);
    setIconSize({14, 14});
    setMaxVisibleItems(30);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    addItems(before);
    for (const app::Variant& variant : all_)
        addItem(markerIcon(variant), app::titleOf(variant));
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

} // namespace ui

#include "moc_variant_box.cpp"

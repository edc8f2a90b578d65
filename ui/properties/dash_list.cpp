// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/properties/dash_list.h"

#include "app/drawing/dash_patterns.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/icon_sign.h"

namespace ui {

DashList::DashList()
{
    setToolTip(Text::tr("Dashes"));
    setAccessibleName(Text::tr("Dashes"));
    setIconSize({36, 12});
    setFixedHeight(space::fieldHeight);
    for (const app::DashPattern& pattern : app::dashPatterns()) {
        addItem(dashIcon(pattern), QString());
        setItemData(count() - 1, pattern.name, Qt::AccessibleTextRole);
        setItemData(count() - 1, pattern.name, Qt::ToolTipRole);
    }
    connect(this, &QComboBox::activated, this, [this](int index) {
        const auto& pattern = app::dashPatterns()[std::size_t(index)];
        emit picked([&](app::Style& style) { style.dashes = app::scaled(pattern, style.width); });
    });
}

void DashList::follow(std::span<const app::Style> styles)
{
    const auto same = app::common(styles, app::patternOf);
    const auto pattern = same.value_or(std::nullopt);
    setPlaceholderText(pattern ? QString() : same ? Text::tr("own", "dashes") : Text::tr("mixed"));
    setCurrentIndex(pattern ? int(*pattern) : -1);
}

} // namespace ui

#include "moc_dash_list.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/look_icon.h"
#include "ui/look/text.h"

#include <QToolButton>

namespace ui {

/// A small flat button of a panel with an icon (`resources/icons`) and a tooltip.
inline QToolButton* iconButton(std::string_view key, const QString& name)
{
    auto* button = new QToolButton;
    button->setIcon(icon(key));
    button->setIconSize({16, 16});
    button->setFixedSize(24, 24);
    button->setAutoRaise(true);
    button->setToolTip(name);
    button->setAccessibleName(name);
    return button;
}

/// The switch beside fields for width and height.
inline QToolButton* ratioButton()
{
    QToolButton* button = iconButton("chain", Text::tr("Keep the ratio of width to height"));
    button->setCheckable(true);
    return button;
}

} // namespace ui

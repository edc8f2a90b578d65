// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/link_button.h"

#include <QToolButton>

namespace ui {

QToolButton* linkButton()
{
    auto* button = new QToolButton;
    button->setAutoRaise(true);
    button->setFocusPolicy(Qt::TabFocus);
    button->setStyleSheet(
        QStringLiteral("QToolButton { color: palette(link); border: none; padding: 0 4px; }"
                       "QToolButton:hover, QToolButton:focus { text-decoration: underline; }"));
    return button;
}

} // namespace ui

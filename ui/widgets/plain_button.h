// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/look_icon.h"

#include <QPushButton>

namespace ui {

/// A button for a window made of a QDialog: Enter presses it only while it has the focus.
inline QPushButton* plainButton(const QString& text, std::string_view iconKey = {})
{
    auto* button = new QPushButton(text);
    button->setAutoDefault(false);
    if (!iconKey.empty())
        button->setIcon(icon(iconKey));
    return button;
}

} // namespace ui

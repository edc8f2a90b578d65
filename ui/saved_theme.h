// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/settings/remembered.h"
#include "ui/look.h"

namespace ui {

/// The theme that the settings remember, or that of the desktop.
inline Theme savedTheme()
{
    return Theme(app::rememberedNumber(QStringLiteral("theme"), int(Theme::System),
                                       int(Theme::Dark), int(Theme::System)));
}

} // namespace ui

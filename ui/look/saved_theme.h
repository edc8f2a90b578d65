// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/settings/remembered.h"
#include "ui/look/look.h"

namespace ui {

/// The theme stored in the settings; by default the desktop's.
inline Theme savedTheme()
{
    return Theme(app::rememberedNumber(QStringLiteral("theme"), int(Theme::System),
                                       int(Theme::Dark), int(Theme::System)));
}

} // namespace ui

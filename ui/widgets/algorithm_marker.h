// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/algorithm_mark.h"
#include "ui/look/look.h"

namespace ui {

/// The background of a widget, for the colours of algorithms (app/view/algorithm_mark.h).
inline app::Ground groundOf(const QPalette& palette)
{
    return lookOf(palette).dark ? app::Ground::Dark : app::Ground::Light;
}

} // namespace ui

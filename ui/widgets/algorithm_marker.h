// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/algorithm_mark.h"
#include "ui/look/look_icon.h"

namespace ui {

/// The background of a widget, for the colours of algorithms (app/view/algorithm_mark.h).
inline app::Ground groundOf(const Look& look)
{
    return look.dark ? app::Ground::Dark : app::Ground::Light;
}
inline app::Ground groundOf(const QPalette& palette) { return groundOf(lookOf(palette)); }

/// The mark of a variant, as an icon of 14 logical pixels.
inline QIcon markerIcon(const app::Variant& variant)
{
    return paintedIcon({14, 14}, [variant](QPainter& painter, const Look& look) {
        app::paintMarker(painter, QRectF(1, 1, 12, 12), variant, groundOf(look));
    });
}

} // namespace ui

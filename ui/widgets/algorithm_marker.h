// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"
#include "app/comparison/variants.h"
#include "app/view/algorithm_mark.h"
#include "ui/look/look_icon.h"

#include <QString>
#include <QStyleOption>

class QPainter;

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

/// The key that chooses an algorithm while the canvas has the focus: 0 the default one, 1 to 9 the
/// first nine of the catalogue; empty for the others.
inline QString digitOf(const clipping::Algorithm& algorithm)
{
    constexpr int digits = 9;
    const auto row = &algorithm - clipping::algorithms().data();
    return &algorithm == &app::usualAlgorithm() ? QStringLiteral("0")
           : row < digits                       ? QString::number(row + 1)
                                                : QString();
}

/// Paints a variant's name at the left of a table cell: the marker, filled or hollow, the
/// abbreviation, and a muted "as published", shortened if it does not fit. A known misprint is
/// shown by its name.
void paintVariantName(QPainter& painter, const QRect& cell, const QStyleOptionViewItem& option,
                      const app::Variant& variant);

} // namespace ui

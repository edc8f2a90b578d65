// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/usual_algorithm.h"

#include <QString>

namespace ui {

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

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

#include <QString>

namespace ui {

/// The key that chooses an algorithm while the canvas has the focus: 1 to 9 and then 0, in the
/// order of the catalogue; empty for those behind.
inline QString digitOf(const clipping::Algorithm& algorithm)
{
    constexpr int digits = 10;
    const auto row = &algorithm - clipping::algorithms().data();
    return row < digits ? QString::number((row + 1) % digits) : QString();
}

} // namespace ui

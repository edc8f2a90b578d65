// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "tests/ui/fresh/lived.h"

namespace ui {

/// What a person sees in one state of the program; its picture is tests/ui/screens/NAME.png.
struct Screen {
    QString name;
    std::function<QImage()> picture;
};

/// A widget at rest, without what blinks.
inline QImage atRest(QWidget& widget)
{
    settle();
    return painted(widget);
}

} // namespace ui

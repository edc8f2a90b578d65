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

/// The same in the dark theme; not for a desk or a window, which choose their theme.
inline Screen inTheDark(const Screen& screen)
{
    return {screen.name + "-dark", [screen] {
                applyTheme(*qApp, Theme::Dark);
                return screen.picture();
            }};
}

} // namespace ui

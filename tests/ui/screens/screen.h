// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "tests/ui/fresh/lived.h"
#include "tests/ui/screens/words.h"

namespace ui {

struct Seen {
    QImage picture;
    QString words;
};

/// What a person sees in one state of the program; its picture is tests/ui/screens/NAME.png, its
/// words are in NAME.txt.
struct Screen {
    QString name;
    std::function<Seen()> look;
};

/// A widget at rest, without what blinks.
inline Seen atRest(QWidget& widget)
{
    settle();
    return {painted(widget), wordsOf(widget)};
}

/// The same in the dark theme; not for a desk or a window, which choose their theme.
inline Screen inTheDark(const Screen& screen)
{
    return {screen.name + "-dark", [screen] {
                applyTheme(*qApp, Theme::Dark);
                return screen.look();
            }};
}

} // namespace ui

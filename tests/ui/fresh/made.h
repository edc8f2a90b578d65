// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "tests/ui/fresh/changes.h"
#include "tests/ui/fresh/makers.h"
#include "tests/ui/fresh/settled.h"

// For tests that look at every widget of makers.h once, each in a row of its own.

namespace ui {

/// The rows of such a test.
inline void addEveryMaker()
{
    QTest::addColumn<int>("number");
    int number = 0;
    for (const Maker& maker : makers())
        QTest::newRow(maker.name) << number++;
}

/// The widget of a row, shown and at rest, on a desk with a full drawing.
struct Made {
    explicit Made(int number) : desk(3)
    {
        desk_changes::openFull(desk);
        const Maker maker = makers()[std::size_t(number)];
        window.reset(maker.make(desk));
        window->resize(maker.size);
        open(maker, *window, desk);
        settle();
    }

    Desk desk;
    std::unique_ptr<QWidget> window;
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/canvas.h"

#include <QToolButton>

namespace ui {

class TickingMenu;

/// Switches snapping, and chooses the kinds of places that the pointer snaps to.
class SnapChoice : public QWidget {
    Q_OBJECT

public:
    explicit SnapChoice(Canvas& canvas);

    /// Where there is no room for the list of kinds, a right click on the magnet opens it.
    void showKinds(bool shown);

private:
    void addKinds();
    void follow();

    Canvas& canvas_;
    QToolButton *switch_, *kinds_;
    TickingMenu* menu_;
};

} // namespace ui

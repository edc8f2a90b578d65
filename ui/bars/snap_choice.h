// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/canvas.h"

#include <QToolButton>

namespace ui {

class TickingMenu;

/// Switches snapping. Its arrow, a right click or Alt+Down opens the kinds of places that the
/// pointer snaps to.
class SnapChoice : public QToolButton {
    Q_OBJECT

public:
    explicit SnapChoice(Canvas& canvas);

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    void addKinds();
    void follow();

    Canvas& canvas_;
    TickingMenu* menu_;
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/canvas.h"

#include <QLabel>

namespace ui {

/// A note over the clip window of somebody's first drawing; it follows the window on the screen and
/// goes when the window is changed.
class WindowNote : public QLabel {
    Q_OBJECT

public:
    WindowNote(const app::Session& session, Canvas& canvas);

signals:
    void learnt(); ///< the window was changed: never again

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    void place();

    const app::Session& session_;
    Canvas& canvas_;
};

} // namespace ui

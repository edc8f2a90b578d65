// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QToolButton>
#include <QWidget>

namespace ui {

class Canvas;
class Segments;

/// The options of the tool Clip window: the shape of the next window, and windows of selected
/// objects.
class WindowOptions : public QWidget {
    Q_OBJECT

public:
    WindowOptions(app::Session& session, Canvas& canvas);

private:
    void follow();
    void followSelection();

    app::Session& session_;
    Segments* shape_;
    QToolButton* fromSelection_;
};

} // namespace ui

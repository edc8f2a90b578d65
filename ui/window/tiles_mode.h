// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/live_sheets.h"

#include <QPointer>
#include <QWidget>

namespace ui {

class Canvas;
class Centre;
class TilesPage;

/// The sheets of the drawing in place of the canvas. Their page is made when it is first entered.
class TilesMode : public QObject {
    Q_OBJECT

public:
    TilesMode(app::Session& session, app::LiveSheets& sheets, Canvas& canvas, Centre& centre);

    void enter();       ///< ends the canvas's gesture, and remembers what has the focus
    void returnFocus(); ///< to what had it on entering, or else to the canvas

signals:
    void made(ui::TilesPage* page);

private:
    app::Session& session_;
    app::LiveSheets& sheets_;
    Canvas& canvas_;
    Centre& centre_;
    QPointer<QWidget> focusBefore_;
};

} // namespace ui

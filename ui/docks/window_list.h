// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/docks/window_model.h"
#include "ui/widgets/panel_list.h"

namespace ui {

/// The list of clip windows: eye, what the window does, shape, name. The current row is the window
/// that tools act on.
class WindowList : public PanelList {
    Q_OBJECT

public:
    explicit WindowList(app::Session& session);

    void shift(int rows); ///< moves the current window up (-1) or down in the list

private:
    void follow();
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

    app::Session& session_;
};

} // namespace ui

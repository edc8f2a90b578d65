// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/docks/window_model.h"
#include "ui/widgets/panel_list.h"

namespace ui {

/// The list of clip windows: eye, what the window does, shape, name. The current row is the window
/// that tools act on. Rows are dragged to another place of the list. A click on the sign of what a
/// window does opens the choice.
class WindowList : public PanelList {
    Q_OBJECT

public:
    explicit WindowList(app::Session& session);

    void shift(int rows); ///< moves the current window up (-1) or down in the list

private:
    void follow();
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    bool pressesEye(const QMouseEvent& event);
    void openOperations(const QModelIndex& row);
    int gapAt(int y) const; ///< the gap between rows that is nearest: 0 is above the first row
    void drop();

    app::Session& session_;
    struct Press {
        int row;
        QPoint at;
    };
    std::optional<Press> pressed_; ///< the row under the pressed button
    std::optional<int> eye_;       ///< the row on whose eye the button is pressed
    std::optional<int> gap_;       ///< where the dragged row would go; empty: none is dragged
};

} // namespace ui

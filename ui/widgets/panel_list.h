// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QKeyEvent>
#include <QListView>

namespace ui {

/// A list in a panel that takes only the keys that move in it. All others, such as the letters of
/// tools and Delete, go on to the main window, which passes them to the canvas.
class PanelList : public QListView {
    Q_OBJECT

protected:
    void keyPressEvent(QKeyEvent* event) override
    {
        switch (event->key()) {
        case Qt::Key_Up:
        case Qt::Key_Down:
        case Qt::Key_Left:
        case Qt::Key_Right:
        case Qt::Key_PageUp:
        case Qt::Key_PageDown:
        case Qt::Key_Home:
        case Qt::Key_End:
            return QListView::keyPressEvent(event);
        default:
            event->ignore();
        }
    }
};

} // namespace ui

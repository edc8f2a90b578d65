// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

namespace ui {

/// A drop-down list beside the canvas. It returns the keyboard focus when the open list closes and
/// on Enter. In the closed list, the arrow keys select and the focus stays. In the open one a
/// letter finds a row, also where it is the key of a tool on the canvas.
class ToolList : public QComboBox {
    Q_OBJECT

public:
    using QComboBox::QComboBox;

    void showPopup() override;
    void hidePopup() override;

signals:
    void done(); ///< the focus should return to the canvas

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    static bool takesLetter(QEvent& event); ///< accepts a letter that would be a shortcut

private:
    bool open_ = false;
};

} // namespace ui

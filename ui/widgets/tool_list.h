// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QComboBox>

namespace ui {

/// A drop-down list beside the canvas. When the open list is closed, and at Enter, it gives the
/// keyboard back; the arrow keys choose in the closed list, and stay there.
class ToolList : public QComboBox {
    Q_OBJECT

public:
    using QComboBox::QComboBox;

    void showPopup() override;
    void hidePopup() override;

signals:
    void done(); ///< back to the canvas

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    bool open_ = false;
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/properties/style_panel.h"
#include "ui/widgets/popup.h"

class QLabel;

namespace ui {

/// The panel Style as a small window below a button. Undo and Redo work in it.
class StylePopup : public Popup {
    Q_OBJECT

public:
    StylePopup(app::Session& session, Canvas& canvas, QWidget* parent);

    StylePanel& panel() { return *panel_; }
    void open(QWidget& below);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void closeEvent(QCloseEvent* event) override;

private:
    app::Session& session_;
    Canvas& canvas_;
    QLabel* title_;
    StylePanel* panel_;
};

} // namespace ui

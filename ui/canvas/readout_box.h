// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/controller.h"

#include <QFrame>
#include <QLabel>
#include <QLineEdit>

namespace ui {

class IconSign;

/// The numbers of the gesture beside the pointer, with a field for each. Typing opens a field,
/// which then has the keyboard; the mouse stays with the canvas.
class ReadoutBox : public QFrame {
    Q_OBJECT

public:
    ReadoutBox(Controller& controller, QWidget* parent);

    /// The surface beside whose pointer the box is shown; it gets the keyboard back.
    void setSurface(QWidget* surface);

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    struct Cell {
        IconSign* lock;
        QLabel* name;
        QLineEdit* field;
    };
    Cell makeCell();
    void follow();
    void showNumber(std::size_t number, const app::Point& end);
    void place();
    void open();
    void goOn();
    void giveBackKeyboard();
    bool key(const QKeyEvent& event);

    Controller& controller_;
    Typing& typing_;
    QWidget* surface_ = nullptr;
    std::array<Cell, app::mostNumbers> cells_{};
    QLabel* error_;
};

} // namespace ui

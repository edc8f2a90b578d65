// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QApplication>

namespace ui {

class MainWindow;

/// The application of the editor. If memory runs out while an event is handled, the rest of the
/// handling is given up, and the window says so: the program does not end.
class EditorApplication : public QApplication {
    Q_OBJECT

public:
    using QApplication::QApplication;

    void setWindow(MainWindow* window) { window_ = window; } ///< that says it; null: none
    bool notify(QObject* receiver, QEvent* event) override;

private:
    void sayTooLittle(bool changed) noexcept;

    MainWindow* window_ = nullptr;
    bool saying_ = false;
};

} // namespace ui

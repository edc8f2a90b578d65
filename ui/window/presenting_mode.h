// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFont>

#include <optional>

class QWidget;

namespace ui {

/// What presenting on a projector changes around the drawing: the window fills the screen, and all
/// type of the program is larger. The drawing itself follows `Display::presenting`.
class PresentingMode {
public:
    explicit PresentingMode(QWidget& window) : window_(window) {}
    ~PresentingMode(); ///< restores the type, which belongs to the program, not to the window
    PresentingMode(const PresentingMode&) = delete;
    PresentingMode& operator=(const PresentingMode&) = delete;

    void enter();
    void leave(); ///< restores type and window as they were on entering

private:
    QWidget& window_;
    std::optional<QFont> fontBefore_; ///< empty: not presenting
    Qt::WindowStates statesBefore_{};
};

} // namespace ui

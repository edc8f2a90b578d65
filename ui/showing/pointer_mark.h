// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

namespace ui {

/// The pointer of a show: an arrow, with a ring around its tip while its button is pressed. The
/// mouse goes through it.
class PointerMark : public QWidget {
public:
    explicit PointerMark(QWidget* parent);

    void pointAt(const QPoint& tip); ///< in the parent
    void setPressed(bool pressed);

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    bool pressed_ = false;
};

} // namespace ui

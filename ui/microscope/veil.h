// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QPainter;

namespace ui {

/// Covers what would answer a question that is open: a plain ground with a closed eye. It lies over
/// the whole of the widget that it belongs to, as long as it is shown.
class Veil : public QWidget {
    Q_OBJECT

public:
    explicit Veil(QWidget* over);

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
};

/// The same on a part of a picture; its words are left out where there is no room.
void paintVeil(QPainter& painter, const QRect& area, const QPalette& palette);

} // namespace ui

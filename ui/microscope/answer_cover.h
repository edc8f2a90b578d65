// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QPainter;

namespace ui {

/// Covers a widget that would give away the answer to an open question: a plain background with a
/// closed eye. While shown it covers its whole parent widget.
class AnswerCover : public QWidget {
    Q_OBJECT

public:
    explicit AnswerCover(QWidget* over);

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;
};

/// Paints the same cover on a part of a picture; omits its text if there is no room.
void paintAnswerCover(QPainter& painter, const QRect& area, const QPalette& palette);

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/practice/practice.h"

#include <QWidget>

class QMouseEvent;

namespace ui {

class MicroscopeView;

/// The diamond with which the student places a cut on the line: a press or a drag at the line moves
/// it, and it is checked beside the figure. It lies over the view, which gets all other events.
class PlaceMark : public QWidget {
    Q_OBJECT

public:
    PlaceMark(app::Practice& practice, MicroscopeView& view);

    std::optional<QPointF> place() const { return place_; } ///< in the view; empty: not shown

protected:
    void paintEvent(QPaintEvent* event) override;
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void follow();
    bool moveTo(const QMouseEvent& event);

    app::Practice& practice_;
    MicroscopeView& view_;
    std::optional<QPointF> place_;
    bool drags_ = false;
};

} // namespace ui

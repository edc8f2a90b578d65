// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/aim.h"
#include "ui/tools/guide_drag.h"

#include <QMouseEvent>

namespace ui {

/// The pointer over the canvas: its left button is for the tool, or for what the canvas offers; the
/// middle one drags the view, as does the left one with Space. New guides are dragged from the
/// rulers.
class Pointing : public QObject {
    Q_OBJECT

public:
    Pointing(HeldTool& held, Aim& aim, Navigation& navigation)
        : held_(held), aim_(aim), navigation_(navigation)
    {
    }

    bool drags() const { return panningFrom_ || guide_.going(); } ///< the view, or a new guide
    QCursor cursor() const;
    void handle(const QMouseEvent& event);
    void leave();
    void setSpace(bool down);
    void stopPanning() { panningFrom_.reset(); }

    /// Selects the object there, unless it is selected already; false: there is none. For the menu
    /// of the right button.
    bool selectAt(const QPointF& screen);

    /// A new guide follows the pointer: from a ruler, until it is dropped. `axis` as in app::Guide.
    void dragGuide(int axis);
    void moveGuide(const QPointF& screen, Qt::KeyboardModifiers modifiers);
    void dropGuide();
    void cancelGuide();
    const GuideDrag& guide() const { return guide_; }

signals:
    void moved(std::optional<app::Point> position);
    void changed(); ///< repaint

private:
    void press(const QMouseEvent& event);
    bool pressOffer(const QMouseEvent& event);
    void move(const QMouseEvent& event);
    void release(const QMouseEvent& event);
    void pan(std::optional<QPointF> from);
    Pointer at(const QMouseEvent& event)
    {
        return aim_.at(event.position(), event.buttons(), event.modifiers());
    }

    HeldTool& held_;
    Aim& aim_;
    Navigation& navigation_;
    GuideDrag guide_;
    std::optional<QPointF> panningFrom_;
    bool space_ = false;
    /// The left button was last pressed on the offered handle, so the tool does not get the click.
    bool onOffer_ = false;
};

} // namespace ui

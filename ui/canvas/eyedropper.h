// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/view/picking.h"
#include "ui/canvas/canvas.h"

#include <functional>

namespace ui {

/// Takes a colour from the drawing: a click on a line or an area passes its colour on. The colour
/// under the pointer is shown beside it. Esc, the right button or another start give up. The tool
/// in hand gets no click meanwhile.
class Eyedropper : public QObject {
    Q_OBJECT

public:
    using Taken = std::function<void(const app::Colour&)>;

    /// Starts one on this canvas.
    static void start(Canvas& canvas, app::Session& session, Taken taken);
    ~Eyedropper() override;

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    Eyedropper(Canvas& canvas, app::Session& session, Taken taken);
    bool pointerEvent(const QWidget& surface, const QEvent& event);
    void leave();
    std::optional<app::Colour> colourAt(const QPointF& place) const;
    void showAt(const QWidget& surface, const QPointF& place);
    void take(const QPointF& place);
    void end();

    Canvas& canvas_;
    app::Session& session_;
    app::Picking picking_;
    Taken taken_;
    QWidget* chip_;     ///< of the canvas
    bool over_ = false; ///< the pointer is over the drawing
    bool pressed_ = false;
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/window_note.h"

#include "ui/look.h"

#include <QPainter>

namespace ui {

WindowNote::WindowNote(const app::Session& session, Canvas& canvas)
    : QLabel(&canvas), session_(session), canvas_(canvas)
{
    setText(tr("<b>Drag the window.</b> What it leaves out is cut, at every frame."));
    setContentsMargins(12, 8, 12, 8);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    adjustSize();
    connect(&canvas, &Canvas::viewChanged, this, &WindowNote::place);
    connect(&canvas, &Canvas::frameShown, this, &WindowNote::place);
    connect(&session.drawing, &app::Drawing::changed, this, [this](const app::Change& change) {
        if (change.kind == app::Change::Kind::Window && isVisible())
            emit learnt();
    });
    place();
}

void WindowNote::place()
{
    const clipping::Window& window = session_.sheet().window;
    const QWidget* drawing = canvas_.focusProxy() ? canvas_.focusProxy() : &canvas_;
    const QPoint origin = drawing->mapTo(&canvas_, QPoint());
    const app::Point middle =
        canvas_.view().toScreen({(window.min.x + window.max.x) / 2, window.min.y});
    const QPoint at(int(middle.x) - width() / 2, int(middle.y) - height() - 18);
    move(origin + QPoint(std::max(at.x(), 8), std::max(at.y(), 8)));
}

void WindowNote::paintEvent(QPaintEvent* event)
{
    const Look& look = lookOf(palette());
    QPainter painter(this);
    painter.fillRect(rect(), look.base);
    painter.setPen(look.accent);
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
    painter.end();
    QLabel::paintEvent(event);
}

} // namespace ui

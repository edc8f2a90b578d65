// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/pointing.h"

#include "ui/canvas/view_commands.h"
#include "ui/canvas/window_offer.h"
#include "ui/canvas/window_tags.h"
#include "ui/editing/keeping.h"
#include "ui/tools/group_choice.h"
#include "ui/tools/picking_marks.h"

#include <utility>

namespace ui {

void Pointing::handle(const QMouseEvent& event)
{
    const bool again = event.type() == QEvent::MouseButtonDblClick;
    if (event.type() == QEvent::MouseMove)
        move(event);
    else if (event.type() == QEvent::MouseButtonRelease)
        release(event);
    else if (again && event.button() == Qt::MiddleButton)
        fitDrawing(held_.session(), navigation_);
    else
        press(event);
    held_.pointer = at(event);
    if (event.type() == QEvent::MouseButtonRelease)
        aim_.forget(); // the snapped action is finished
    emit moved(held_.pointer->position);
}

void Pointing::press(const QMouseEvent& event)
{
    if (event.button() == Qt::MiddleButton || (event.button() == Qt::LeftButton && space_))
        return pan(event.position());
    if (event.button() != Qt::LeftButton || pressOffer(event))
        return;
    const Pointer pointer = at(event);
    if (!held_.mayDraw()) {
        emit held_.session().refused(held_.hint());
        return;
    }
    const bool again = event.type() == QEvent::MouseButtonDblClick;
    held_.use([&](Tool& tool, Workbench& bench) {
        again ? tool.doubleClick(pointer, bench) : tool.press(pointer, bench);
    });
}

// Whether the offered handle or the name of a window takes the click. At the second press of a
// double click it no longer exists.
bool Pointing::pressOffer(const QMouseEvent& event)
{
    if (onOffer_ && event.type() == QEvent::MouseButtonDblClick)
        return true;
    const auto tag = tagAt(event.position(), held_);
    onOffer_ = tag || offeredHandle(held_).contains(event.position());
    if (tag)
        held_.session().chooseWindow(*tag);
    else if (onOffer_)
        layWindowOnPage(held_.session());
    return onOffer_;
}

void Pointing::move(const QMouseEvent& event)
{
    if (panningFrom_) {
        navigation_.pan(event.position() - *panningFrom_);
        panningFrom_ = event.position();
        return;
    }
    const Pointer pointer = at(event);
    held_.use([&](Tool& tool, Workbench& bench) {
        held_.pointer = pointer; // the hint depends on it, too
        tool.move(pointer, bench);
    });
}

void Pointing::release(const QMouseEvent& event)
{
    if (panningFrom_ && (event.button() == Qt::MiddleButton || event.button() == Qt::LeftButton))
        return pan(std::nullopt);
    if (event.button() != Qt::LeftButton || onOffer_)
        return;
    const Pointer pointer = at(event);
    held_.use([&](Tool& tool, Workbench& bench) { tool.release(pointer, bench); });
}

void Pointing::pan(std::optional<QPointF> from)
{
    panningFrom_ = from;
    emit changed();
}

void Pointing::leave()
{
    aim_.forget();
    held_.use([this](Tool& tool, Workbench& bench) {
        held_.pointer.reset();
        tool.leave(bench);
    });
    emit moved(std::nullopt);
}

void Pointing::setSpace(bool down)
{
    if (std::exchange(space_, down) != down)
        emit changed();
}

QCursor Pointing::cursor() const
{
    if (panningFrom_ || space_)
        return panningFrom_ ? Qt::ClosedHandCursor : Qt::OpenHandCursor;
    if (const auto& pointer = held_.pointer) {
        const QPointF at(pointer->screen.x, pointer->screen.y);
        if (offeredHandle(held_).contains(at) || tagAt(at, held_))
            return Qt::PointingHandCursor;
    }
    if (!held_.mayDraw())
        return Qt::ForbiddenCursor;
    const QCursor own = held_.tool().cursor(held_.bench());
    return aim_.snapped() && own.shape() == Qt::CrossCursor ? Qt::BlankCursor
                                                            : own; // the marker replaces it
}

bool Pointing::selectAt(const QPointF& screen)
{
    app::Session& session = held_.session();
    const Pointer pointer = aim_.at(screen);
    bool found = false;
    held_.use([&](Tool& tool, Workbench& bench) {
        found = tool.as<SelectsForMenu>().selectForMenu(pointer, bench);
    });
    if (found)
        return true;
    const auto [segment, object] = pickedAt(pointer.raw, held_.bench());
    if (object && !session.selection().contains(*object) && choose(object, {}, session))
        session.inspect(segment);
    return object.has_value();
}

void Pointing::dragGuide(int axis)
{
    if (!held_.session().display().guides)
        held_.session().changeDisplay([](app::Display& display) { display.guides = true; });
    guide_.start(axis);
}

void Pointing::moveGuide(const QPointF& screen, Qt::KeyboardModifiers modifiers)
{
    if (!guide_.going())
        return;
    held_.pointer = aim_.withoutTool(screen, modifiers);
    held_.use([this](Tool&, Workbench& bench) { guide_.proceed(*held_.pointer, bench); });
    emit moved(held_.pointer->position);
}

void Pointing::dropGuide()
{
    aim_.forget();
    held_.use([this](Tool&, Workbench& bench) {
        if (guide_.going())
            guide_.finish(bench);
    });
}

void Pointing::cancelGuide()
{
    held_.use([this](Tool&, Workbench& bench) { guide_.cancel(bench); });
    aim_.forget();
}

} // namespace ui

#include "moc_pointing.cpp"

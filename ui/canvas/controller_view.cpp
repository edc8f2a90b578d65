// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/scene/bounds.h"
#include "ui/canvas/controller.h"

#include <glm/common.hpp>

namespace ui {

void Controller::fitDrawing()
{
    const auto lines = app::boundsOf(session_.scene.lines());
    lines ? navigation_.show(*lines) : fitPage();
}

void Controller::fitPage()
{
    clipping::Window all = session_.now().page().rectangle();
    if (const auto lines = app::boundsOf(session_.scene.lines()))
        all = {glm::min(all.min, lines->min), glm::max(all.max, lines->max)};
    navigation_.show(all);
}

void Controller::fitSelection()
{
    const auto& bounds = session_.selectionBounds();
    bounds ? navigation_.show(*bounds) : fitDrawing();
}

void Controller::fitWindow() { navigation_.show(clipWindow().value_or(window())); }

static double pixelsPerUnit(const app::Page& page)
{
    return page.millimetresPerUnit() / app::infoOf(app::Unit::Px).millimetres;
}

double Controller::zoom() const { return view().zoom / pixelsPerUnit(session_.now().page()); }

void Controller::setZoom(double zoom)
{
    const QPointF middle(view().size.x / 2, view().size.y / 2);
    navigation_.zoomAt(middle, zoom / this->zoom());
}

} // namespace ui

// New guides, which are dragged from the rulers.

namespace ui {

void Controller::dragGuide(int axis)
{
    endGesture();
    if (!session_.display().guides)
        session_.changeDisplay([](app::Display& display) { display.guides = true; });
    guide_.start(axis);
}

void Controller::moveGuide(const QPointF& screen, Qt::KeyboardModifiers modifiers)
{
    if (!guide_.going())
        return;
    const app::Point at(screen.x(), screen.y()), raw = view().toDrawing(at);
    app::SnapQuery query{raw, bench_.inDrawing(snapReach), snapNow_};
    query.grid = bench_.grid();
    query.guides = bench_.guides();
    const auto snap = modifiers & Qt::ControlModifier ? std::nullopt : snapper_.at(query);
    const app::Point place = snap ? snap->point : raw;
    pointer_ = Pointer{place, raw, at, Qt::LeftButton, modifiers, place};
    snap_ = snap;
    guide_.proceed(*pointer_);
    emit pointerMoved(pointer_->position);
    emit changed();
}

void Controller::dropGuide()
{
    snap_.reset();
    withTool([&] {
        if (guide_.going())
            guide_.finish(bench_);
    });
}

} // namespace ui

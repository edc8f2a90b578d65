// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/controller.h"

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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/end_drag.h"

#include "app/commands/change_paths.h"
#include "ui/tools/line_on_screen.h"
#include "ui/tools/shape_drawing.h"

#include <QCoreApplication>

#include <glm/geometric.hpp>

#include <array>

namespace ui {

constexpr double endReach = 8; // pixels

/// The object that would show its ends; empty: there is none, or there are several.
static std::optional<std::size_t> objectWithHandles(const app::Session& session)
{
    if (session.selection().size() == 1)
        return session.selection().first();
    if (!session.selection().empty() || !session.inspected())
        return std::nullopt;
    return session.scene.lines().objectOf(*session.inspected());
}

std::optional<clipping::Segment> lineWithHandles(const app::Session& session)
{
    const auto object = objectWithHandles(session);
    if (!object)
        return std::nullopt;
    const auto line = session.now().objects()[*object].singleLine();
    const bool isPoint = line && line->a == line->b;
    return line && !isPoint && session.now().editable(*object) ? line : std::nullopt;
}

std::optional<EndDrag::End> EndDrag::endAt(const app::Point& screen, const Workbench& bench)
{
    const auto line = lineWithHandles(bench.session);
    if (!line)
        return std::nullopt;
    const double a = glm::distance(bench.view.toScreen(line->a), screen);
    const double b = glm::distance(bench.view.toScreen(line->b), screen);
    if (!(std::min(a, b) <= endReach))
        return std::nullopt;
    return a < b ? End::A : End::B;
}

void EndDrag::start(End end, const Pointer& pointer, Workbench& bench)
{
    line_ = lineWithHandles(bench.session);
    end_ = end;
    pressed_ = pointer.screen;
    moved_ = false;
}

clipping::Segment EndDrag::movedTo(const app::Point& point) const
{
    return end_ == End::A ? clipping::Segment{point, line_->b} : clipping::Segment{line_->a, point};
}

void EndDrag::proceed(const Pointer& pointer, Workbench& bench)
{
    if (lineWithHandles(bench.session) != line_)
        return cancel(bench); // it was changed meanwhile
    moved_ = moved_ || dragged(pressed_, pointer);
    if (!moved_)
        return;
    now_ = movedTo(pointer.position);
    bench.session.setPreview({.line = now_});
}

bool EndDrag::finish(const Pointer& pointer, Workbench& bench)
{
    proceed(pointer, bench);
    const bool moved = moved_;
    moved ? accept(pointer.position, bench) : cancel(bench);
    return moved;
}

void EndDrag::accept(const app::Point& point, Workbench& bench)
{
    app::Session& session = bench.session;
    if (!line_ || lineWithHandles(session) != line_)
        return cancel(bench);
    const clipping::Segment line = movedTo(point);
    const auto inspected = session.inspected();
    const std::size_t object = *objectWithHandles(session);
    if (line != *line_ && line.a != line.b) {
        const std::array changed{app::ChangedPath{object, app::Path(line)}};
        session.history.push(
            new app::ChangePaths(session.document, changed,
                                 QCoreApplication::translate("Commands", "Move end of line")));
        session.inspect(inspected);
    }
    cancel(bench);
}

void EndDrag::cancel(Workbench& bench)
{
    if (going())
        bench.session.setPreview({});
    line_.reset();
    moved_ = false;
}

std::optional<app::Gauge> EndDrag::gauge(const Workbench& bench) const
{
    if (!line_ || !moved_)
        return std::nullopt;
    return gaugeFrom(end_ == End::A ? line_->b : line_->a, app::lengthAndAngle(), bench);
}

void EndDrag::paint(QPainter& painter, const Workbench& bench) const
{
    if (!moved_)
        return;
    painter.setPen(QPen(bench.look.selection, 1.5));
    if (const auto line = lineOnScreen(now_, bench))
        painter.drawLine(*line);
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/end_drag.h"

#include "app/commands/change_paths.h"
#include "ui/look/text.h"
#include "ui/tools/line_on_screen.h"
#include "ui/tools/shape_drawing.h"

#include <glm/geometric.hpp>

#include <array>

namespace ui {

constexpr double endReach = 8; // pixels
constexpr double shortest = 48, beyondEnd = 9;

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
    if (!lineWithHandles(bench.session))
        return std::nullopt;
    const auto [atA, atB] = handles(bench);
    const double a = glm::distance(atA, screen), b = glm::distance(atB, screen);
    if (!(std::min(a, b) <= endReach))
        return std::nullopt;
    return a < b ? End::A : End::B;
}

std::array<app::Point, 2> EndDrag::handles(const Workbench& bench)
{
    const auto line = lineWithHandles(bench.session);
    const app::Point a = bench.view.toScreen(line->a), b = bench.view.toScreen(line->b);
    const double length = glm::distance(a, b);
    if (!(length < shortest))
        return {a, b};
    const app::Point aside = (length > 0 ? (b - a) / length : app::Point(1, 0)) * beyondEnd;
    return {a - aside, b + aside};
}

void EndDrag::start(End end, const Pointer& pointer, Workbench& bench)
{
    last_.forget();
    const app::Session& session = bench.session;
    if (const auto line = lineWithHandles(session))
        now_ = State{*line, session.inspected(), *objectWithHandles(session), end, pointer.screen};
}

app::Point EndDrag::fixed(const State& state)
{
    const auto& [a, b] = state.line;
    if (anchorOf(state.modifiers) == app::Anchor::Centre)
        return a + (b - a) * 0.5;
    return state.end == End::A ? b : a;
}

clipping::Segment EndDrag::moved(const State& state)
{
    const bool centre = anchorOf(state.modifiers) == app::Anchor::Centre;
    const app::Point other = centre ? 2.0 * fixed(state) - state.to : fixed(state);
    return state.end == End::A ? clipping::Segment{state.to, other}
                               : clipping::Segment{other, state.to};
}

void EndDrag::proceed(const Pointer& pointer, Workbench& bench)
{
    if (!now_)
        return;
    if (lineWithHandles(bench.session) != now_->line)
        return cancel(bench); // it was changed meanwhile
    now_->moved = now_->moved || dragged(now_->pressed, pointer);
    if (!now_->moved)
        return;
    if (!corrects() && !pointer.held) // numbers refer to the point that stays
        now_->modifiers = pointer.modifiers;
    now_->to = pointer.position;
    bench.session.setPreview({.line = moved(*now_)});
}

bool EndDrag::finish(const Pointer& pointer, Workbench& bench)
{
    proceed(pointer, bench);
    const bool moved = now_ && now_->moved;
    moved ? accept({pointer.position, {}}, bench) : cancel(bench);
    return moved;
}

void EndDrag::accept(const app::GestureEnd& to, Workbench& bench)
{
    app::Session& session = bench.session;
    if (!now_ || lineWithHandles(session) != now_->line)
        return cancel(bench);
    State state = *now_;
    state.to = to.point;
    const clipping::Segment line = moved(state);
    if (line.a == line.b) {
        emit session.refused(Text::tr("The line would have no length. Drag its end elsewhere."));
        return cancel(bench);
    }
    last_.discard(); // if the step was open, it stays undone
    if (line == state.line)
        return end(bench);
    const std::array changed{app::ChangedPath{state.object, app::Path(line)}};
    session.history.push(
        new app::ChangePaths(session.document, changed, Text::tr("Move end of line")));
    session.inspect(state.inspected);
    cancel(bench);
    last_.remember(bench);
    done_ = state;
}

void EndDrag::cancel(Workbench& bench)
{
    if (going())
        bench.session.setPreview({});
    now_.reset();
    if (!corrects())
        return;
    last_.restore(bench);
    bench.session.inspect(done_.inspected);
}

void EndDrag::reopen(Workbench& bench)
{
    if (!last_.reopen(bench))
        return;
    app::Session& session = bench.session;
    session.select({done_.object});
    session.inspect(done_.inspected);
    now_ = done_;
}

std::optional<app::Gauge> EndDrag::gauge(const Workbench& bench) const
{
    if (now_ ? !now_->moved : !canReopen(bench))
        return std::nullopt;
    const State& state = now_ ? *now_ : done_;
    app::Gauge gauge =
        gaugeFrom(fixed(state), app::lengthAndAngle(anchorOf(state.modifiers)), bench);
    if (!now_ || corrects())
        gauge.aim = app::GestureEnd{done_.to, gauge.measure->values(gauge.start, done_.to)};
    return gauge;
}

void EndDrag::paint(QPainter& painter, const Workbench& bench) const
{
    if (!now_ || !now_->moved)
        return;
    painter.setPen(QPen(bench.look.selection, 1.5));
    if (const auto line = lineOnScreen(moved(*now_), bench))
        painter.drawLine(*line);
}

} // namespace ui

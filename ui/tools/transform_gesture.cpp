// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/transform_gesture.h"

#include "app/commands/move_objects.h"
#include "app/commands/transform_objects.h"
#include "app/document/hidden_objects.h"
#include "ui/look/text.h"
#include "ui/tools/pivot_marks.h"
#include "ui/tools/shape_drawing.h"

#include <glm/geometric.hpp>

namespace ui {
namespace {

app::OwnPoints onlyPoint(const app::Point& point) { return {{point}, {point, point}}; }

} // namespace

app::SnapTo placesOnly()
{
    return app::SnapTo::All.without("alignment").without("drawn-alignment");
}

void TransformGesture::start(const app::Transformation& kind, const app::Point& pivot,
                             const app::Point& pointer, const app::Point& grabbed,
                             const Workbench& bench)
{
    last_.forget();
    const app::Point moved = kind.movesPivot ? pivot : grabbed;
    now_ = State{&kind, {pivot, moved}, moved - pointer, bench.session.selection(), {}};
    now_->pressed = now_->last = pointer;
    now_->end = atRest(*now_);
    const app::Session& session = bench.session;
    now_->own =
        kind.movesPivot
            ? app::ownPointsOf(session.now(), session.scene.lines(), session.selection(),
                               session.selectionBounds().value_or(clipping::Window{}), pointer)
            : onlyPoint(moved);
}

app::Point TransformGesture::grabbedAt(const app::Point& pointer, const app::Point& pivot,
                                       const Workbench& bench)
{
    const app::Point at =
        pointer + bench.moved(onlyPoint(pointer), {0, 0}, {}, {}, placesOnly()).by;
    return glm::distance(at, pivot) > bench.inDrawing(snapReach) ? at : pointer;
}

/// The end of a gesture that has changed nothing yet.
app::GestureEnd TransformGesture::atRest(const State& state)
{
    return {state.start.pointer,
            state.kind->measure(state.axis).values(state.start, state.start.pointer)};
}

void TransformGesture::proceed(const Pointer& pointer, Workbench& bench)
{
    if (!now_)
        return;
    now_->end = {pointer.position, pointer.numbers, now_->end.repeat};
    now_->snap.reset();
    now_->last = pointer.raw;
    const bool steps = pointer.modifiers & Qt::ShiftModifier;
    const bool along = now_->kind->movesPivot && now_->axis != app::Along::Both;
    if (!along && !pointer.held && !steps && !corrects())
        snap(pointer, bench);
}

/// A moved selection snaps by its own points and edges, another one by the point that is grabbed.
void TransformGesture::snap(const Pointer& pointer, const Workbench& bench)
{
    now_->snap =
        bench.moved(now_->own, pointer.raw - now_->pressed, pointer.modifiers, now_->objects,
                    now_->kind->movesPivot ? app::SnapTo::All : placesOnly());
    now_->end.point = now_->start.pointer + now_->snap->by;
    now_->end.numbers = now_->kind->measure(now_->axis).values(now_->start, now_->end.point);
}

bool TransformGesture::finish(const Pointer& pointer, Workbench& bench)
{
    proceed(pointer, bench);
    finish(bench);
    return true;
}

void TransformGesture::finish(Workbench& bench)
{
    if (now_)
        accept(now_->end, bench);
}

void TransformGesture::accept(const app::GestureEnd& end, Workbench& bench)
{
    if (!now_)
        return;
    State state = *now_;
    const auto repeat = state.end.repeat;
    state.end = end;
    if (!end.repeat)
        state.end.repeat = repeat;
    if (isNothing(state)) { // the last step, if it is open, stays undone
        last_.discard();
        return Drag::end(bench);
    }
    if (!push(state, bench))
        return cancel(bench);
    now_.reset();
    last_.discard();
    last_.remember(bench);
    done_ = std::move(state);
}

void TransformGesture::cancel(Workbench& bench)
{
    now_.reset();
    last_.restore(bench);
}

/// The maps of the objects that the step makes: one for each copy.
std::vector<app::AffineMap> TransformGesture::maps(const State& state)
{
    const app::RepeatEntry repeat =
        state.end.repeat.value_or(app::RepeatEntry{1, app::RepeatEntry::How::Times});
    const double part = repeat.how == app::RepeatEntry::How::Parts ? 1.0 / repeat.count : 1;
    std::vector<app::AffineMap> maps;
    for (int i = 1; i <= (state.copies ? repeat.count : 1); ++i)
        maps.push_back(state.kind->map(state.start, state.end, state.axis, i * part));
    return maps;
}

bool TransformGesture::isNothing(const State& state)
{
    const app::AffineMap map = maps(state).front();
    return map == app::AffineMap{.from = map.from, .to = map.from};
}

bool TransformGesture::push(const State& state, Workbench& bench) const
{
    app::Session& session = bench.session;
    const auto all = maps(state);
    const auto isUsable = [](const app::AffineMap& map) {
        return map.isFinite() && map.scale() > 0;
    };
    if (session.selection() != state.objects)
        return false; // a command has removed objects meanwhile
    if (!std::ranges::all_of(all, isUsable)) {
        emit session.refused(
            Text::tr("These numbers leave nothing of the selection, or make it too "
                     "large. Type others."));
        return false;
    }
    if (state.copies && all.size() * state.objects.size() > app::mostCopied) {
        emit session.refused(
            Text::tr("These would be too many objects. Make fewer copies, or select "
                     "fewer objects."));
        return false;
    }
    if (state.copies) {
        app::Edit edit = app::copying(session.now(), state.objects, all, session.entered.id());
        const app::ObjectRanges added = app::addedBy(edit.splices);
        session.history.push(
            new app::CopyObjects(session.document, std::move(edit), Text::tr("Copy selection")));
        session.select(common(added, app::editableObjects(session.now())));
    } else if (state.kind->movesPivot) {
        pushKeepingInspected(session,
                             new app::MoveObjects(session.document, state.objects, all.front().to));
    } else {
        pushKeepingInspected(
            session, new app::TransformObjects(session.document, state.objects, all.front(),
                                               session.arrange.strokes, state.kind->undoText));
    }
    return true;
}

/// Holds an axis, or frees it again.
void TransformGesture::hold(app::Along axis)
{
    now_->axis = now_->axis == axis ? app::Along::Both : axis;
    now_->end = atRest(*now_);
}

/// Puts the pivot where the pointer is, or at the place that it snaps to.
void TransformGesture::putPivot(const Workbench& bench)
{
    if (now_->kind->movesPivot)
        return;
    now_->start.from = now_->last + bench.moved(onlyPoint(now_->last), {0, 0}, {}).by;
    now_->end = atRest(*now_);
}

const TransformGesture::Letter* TransformGesture::letterOf(const QKeyEvent& event)
{
    static const std::array letters{
        Letter{Qt::Key_X, [](auto& gesture, auto&) { gesture.hold(app::Along::X); }},
        Letter{Qt::Key_Y, [](auto& gesture, auto&) { gesture.hold(app::Along::Y); }},
        Letter{Qt::Key_C, [](auto& gesture, auto&) { gesture.now_->copies ^= true; }},
        Letter{Qt::Key_P, [](auto& gesture, auto& bench) { gesture.putPivot(bench); }},
    };
    const auto found = std::ranges::find(letters, event.key(), &Letter::key);
    const bool alone = !(event.modifiers() & ~Qt::KeypadModifier);
    return alone && found != letters.end() ? &*found : nullptr;
}

bool TransformGesture::wants(const QKeyEvent& event) const
{
    return now_ && !corrects() && letterOf(event);
}

bool TransformGesture::key(const QKeyEvent& event, const Workbench& bench)
{
    if (!wants(event))
        return false;
    letterOf(event)->press(*this, bench);
    return true;
}

std::optional<app::Gauge> TransformGesture::gauge(const Workbench& bench) const
{
    if (!now_ && !last_.canReopen(bench))
        return std::nullopt;
    const State& state = now_ ? *now_ : done_;
    app::Gauge gauge = gaugeFrom(state.start.from, state.kind->measure(state.axis), bench);
    gauge.start = state.start;
    gauge.shift = state.shift;
    gauge.repeats = state.copies;
    if (!now_ || last_.isOpen())
        gauge.aim = done_.end;
    else if (now_->snap)
        gauge.aim = now_->end;
    return gauge;
}

void TransformGesture::reopen(Workbench& bench)
{
    if (!last_.reopen(bench))
        return;
    bench.session.select(done_.objects);
    now_ = done_;
}

QString TransformGesture::hint(const Workbench& bench) const
{
    if (now_ && now_->kind->movesPivot)
        return Text::tr(
            "Type a length, Tab, an angle, or x,y; Enter. X, Y: axis, C: copy, Esc: cancel.");
    if (now_)
        return Text::tr(
            "Type a number, Enter. X, Y: axis, P: pivot here, C: copy, Shift: 15° steps, Esc: "
            "cancel.");
    if (last_.canReopen(bench) && done_.copies)
        return Text::tr("Enter, then another number, or 5x for five copies, 5/ to divide the way.");
    if (last_.canReopen(bench))
        return Text::tr("Enter, then another number: change this step.");
    return {};
}

void TransformGesture::paint(QPainter& painter, const Workbench& bench) const
{
    if (!now_)
        return;
    paintCopies(painter, bench, maps(*now_));
    if (now_->kind->movesPivot)
        return;
    const QPointF pivot = bench.onScreen(now_->start.from);
    painter.setPen(QPen(bench.look.selection, 1, Qt::DashLine));
    painter.drawLine(pivot, bench.onScreen(now_->end.point));
    PivotMarks::paintPivot(painter, pivot, bench.look);
}

constexpr double mostPixels = 500'000;    // that lines are long together: some 4 ms
constexpr std::size_t fewPreviewed = 100; // however long they are

void paintMapped(QPainter& painter, const Workbench& bench, const app::AffineMap& map,
                 std::size_t most)
{
    const app::SceneLines& all = bench.session.scene.lines();
    const auto at = [&](const app::Point& p) { return bench.onScreen(map(p)); };
    std::vector<QLineF> lines;
    const QRectF seen(0, 0, bench.view.size.x, bench.view.size.y);
    double left = mostPixels * double(most) / mostPreviewed;
    const auto isFull = [&] {
        return lines.size() >= most || (left < 0 && lines.size() >= fewPreviewed);
    };
    for (const std::size_t shape : bench.session.selection()) {
        if (isFull())
            break;
        const auto end = all.firstLineOf(shape + 1);
        for (auto i = all.firstLineOf(shape); i < end && !isFull(); ++i) {
            const QLineF& line = lines.emplace_back(at(all[i].a), at(all[i].b));
            const QPointF low(std::min(line.x1(), line.x2()), std::min(line.y1(), line.y2()));
            const QPointF high(std::max(line.x1(), line.x2()), std::max(line.y1(), line.y2()));
            const double across = std::min(high.x(), seen.right()) - std::max(low.x(), 0.0);
            const double down = std::min(high.y(), seen.bottom()) - std::max(low.y(), 0.0);
            if (across >= 0 && down >= 0) // what is not seen takes no time
                left -= across + down;
        }
    }
    painter.setPen(QPen(bench.look.selection, 1.5));
    painter.drawLines(lines.data(), int(lines.size()));
}

void paintCopies(QPainter& painter, const Workbench& bench, std::span<const app::AffineMap> copies)
{
    const std::size_t count = std::min(copies.size(), mostPreviewed);
    for (const app::AffineMap& copy : copies.first(count))
        paintMapped(painter, bench, copy, mostPreviewed / count);
}

} // namespace ui

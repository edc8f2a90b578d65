// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/two_point_gesture.h"

#include "app/base/numbers.h"
#include "ui/look/text.h"

#include <typeinfo>

namespace ui {

/// Whether it is measured by a width and a height.
static bool hasSides(const app::GestureMeasure& measure)
{
    const auto isLength = [&](std::size_t i) {
        return measure.fields[i].quantity == app::Quantity::Length && !measure.fields[i].kept;
    };
    return measure.fields.size() > 1 && isLength(0) && isLength(1);
}

void TwoPointGesture::press(const Pointer& pointer, Workbench& bench)
{
    const bool corrects = last_.isOpen();
    if (corrects)
        cancel(bench); // a click ends the correction
    if (gesture_ && !pressed_) {
        move(pointer, bench);
        return finishByClick(bench);
    }
    last_.forget();
    pressed_ = screen_ = pointer.screen;
    begin(corrects ? pointer.steered : pointer.position, bench);
    gesture_->modifiers = pointer.modifiers;
}

void TwoPointGesture::move(const Pointer& pointer, Workbench& bench)
{
    screen_ = pointer.screen;
    waitsAt_ = waitsAt_.value_or(pointer.screen);
    const bool leaves = waits_ && dragged(*waitsAt_, pointer);
    waits_ = waits_ && !leaves;
    if (!gesture_)
        return;
    if (!last_.isOpen())
        gesture_->modifiers = pointer.modifiers;
    gesture_->numbers = pointer.numbers;
    moveEnd(leaves && !pointer.held ? pointer.steered : pointer.position, bench);
}

void TwoPointGesture::release(const Pointer& pointer, Workbench& bench)
{
    const auto pressed = std::exchange(pressed_, std::nullopt);
    if (!pressed || !gesture_ || !dragged(*pressed, pointer))
        return;
    move(pointer, bench);
    finish(bench);
}

void TwoPointGesture::cancel(Workbench& bench)
{
    gesture_.reset();
    pressed_.reset();
    last_.restore(bench);
}

std::optional<app::Gauge> TwoPointGesture::gauge(const Workbench& bench) const
{
    if (!gesture_)
        return gaugeOfStart(bench);
    app::Gauge gauge = gaugeFrom(gesture_->from, measure(gesture_->modifiers), bench);
    gauge.kept = gesture_->numbers;
    if (last_.isOpen()) {
        gauge.aim = app::GestureEnd{done_.to, gauge.measure->values(gauge.start, done_.to)};
    } else if (waits_ && hasSides(*gauge.measure)) {
        gauge.aim = sameAgain(bench);
        gauge.alike = true;
    }
    return gauge;
}

/// Of the size that was made last; empty if the first is made.
std::optional<app::GestureEnd> TwoPointGesture::sameAgain(const Workbench& bench) const
{
    const app::GestureMeasure& measure = this->measure(gesture_->modifiers);
    const app::GestureStart start{gesture_->from};
    const auto last = bench.lastSides.find(typeid(*this));
    app::Point to = gesture_->from;
    if (last != bench.lastSides.end())
        to = measure.end(start, to, {last->second.x, last->second.y});
    return app::GestureEnd{to, measure.values(start, to)};
}

QString TwoPointGesture::hint(const Workbench& bench) const
{
    const auto last = bench.lastSides.find(typeid(*this));
    if (!gesture_ || !waits_ || last == bench.lastSides.end())
        return {};
    const double size = bench.session.now().page().realMillimetresPerUnit();
    const auto length = [&](double side) {
        return app::lengthText(side, bench.session.display().unit, size);
    };
    return Text::tr("Enter: %1 × %2 again. Or type the size, or drag.")
        .arg(length(last->second.x), length(last->second.y));
}

void TwoPointGesture::accept(const app::GestureEnd& end, Workbench& bench)
{
    if (!gesture_)
        return begin(end.point, bench);
    gesture_->numbers = end.numbers;
    moveEnd(end.point, bench);
    last_.isOpen() ? finish(bench) : finishByClick(bench);
}

void TwoPointGesture::reopen(Workbench& bench)
{
    if (!last_.reopen(bench))
        return;
    gesture_ = done_;
    follow(*gesture_, bench);
}

void TwoPointGesture::begin(const app::Point& from, Workbench& bench)
{
    const auto modifiers = gesture_ ? gesture_->modifiers : Qt::KeyboardModifiers();
    gesture_ = {from, from, modifiers, keptBy(keeps(), bench, usual())};
    waits_ = true;
    waitsAt_ = screen_;
    follow(*gesture_, bench);
}

void TwoPointGesture::moveEnd(const app::Point& to, Workbench& bench)
{
    gesture_->to = to;
    follow(*gesture_, bench);
}

std::optional<std::size_t> TwoPointGesture::firstZero() const
{
    return app::firstZero(measure(gesture_->modifiers), {gesture_->from}, gesture_->to);
}

bool TwoPointGesture::refusesEmpty(Workbench& bench) const
{
    const auto zero = firstZero();
    if (zero)
        emit bench.session.refused(Text::tr("%1 must not be 0. Click another place.")
                                       .arg(measure(gesture_->modifiers).fields[*zero].name));
    return zero.has_value();
}

void TwoPointGesture::add(Workbench& bench)
{
    last_.discard();
    make(bench);
    done_ = *gesture_;
    if (const app::GestureMeasure& measure = this->measure(done_.modifiers); hasSides(measure)) {
        const app::Numbers sides = measure.values({done_.from}, done_.to);
        bench.lastSides[typeid(*this)] = glm::abs(app::Point(sides[0], sides[1]));
    }
    last_.remember(bench);
}

void TwoPointGesture::finish(Workbench& bench)
{
    if (refusesEmpty(bench))
        return;
    add(bench);
    if (!keeps().empty())
        bench.kept[keeps()] = gesture_->numbers;
    cancel(bench);
}

} // namespace ui

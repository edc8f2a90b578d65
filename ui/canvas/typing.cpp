// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/typing.h"

namespace ui {

Typing::Typing(HeldTool& held) : held_(held)
{
    connect(&held, &HeldTool::used, this, &Typing::follow);
    connect(&held, &HeldTool::chosen, this, [this] {
        going_ = false;
        readout_.reset(); // the numbers were for the other tool
        follow();
        emit changed();
    });
    connect(&held.session().nodes, &app::NodeEditing::changed, this, &Typing::follow);
    follow();
}

bool Typing::takesNumbers() const
{
    // The last step may be undone by now.
    return readout_ && held_.mayDraw() && numbers().gauge(held_.bench());
}

app::Point Typing::aim() const
{
    const auto& pointer = held_.pointer;
    return pointer ? pointer->steered : readout_ ? readout_->gauge().start.from : app::Point(0);
}

/// Numbers that follow a finished step change it, until the next action.
void Typing::begin(const QString& first, bool inSecondField)
{
    const bool firstPoint = held_.info().beginsAtPoint() && (first == u"#" || first == u"@");
    if (!held_.busy() && !firstPoint)
        held_.use([](Tool& tool, Workbench& bench) { tool.as<TypesNumbers>().reopen(bench); });
    going_ = true;
    if (inSecondField)
        readout_->activate(readout_->gauge().measure->fields.size() > 1 ? 1 : 0);
    type(first);
    emit began();
}

void Typing::type(const QString& text)
{
    if (!readout_)
        return;
    readout_->type(text);
    if (numbers().corrects() && numbers().pointBegins() && readout_->typesPoint())
        typeFirstPoint(text);
    steer();
}

/// What was typed so far for a correction is the beginning of a point for the next gesture.
void Typing::typeFirstPoint(const QString& text)
{
    held_.use([](Tool& tool, Workbench& bench) { tool.cancel(bench); });
    if (!readout_)
        return;
    going_ = true;
    readout_->type(text);
    emit began();
}

void Typing::lock()
{
    if (readout_)
        readout_->lock();
    steer();
}

void Typing::release()
{
    if (readout_)
        readout_->release();
    stop();
}

void Typing::accept()
{
    if (!readout_)
        return;
    if (held_.busy() && !numbers().corrects() && readout_->typesDirection())
        return lock(); // the length is still missing
    if (!readout_->accept(aim())) {
        emit changed();
        return;
    }
    const app::GestureEnd end = readout_->result(aim());
    const bool isPoint = readout_->gauge().measure->points != app::GestureMeasure::Points::Refused;
    going_ = false;
    readout_.reset();
    held_.use([&](Tool& tool, Workbench& bench) {
        if (isPoint && held_.info().draws())
            bench.lastPoint = end.point;
        tool.as<TypesNumbers>().accept(end, bench);
    });
    steer();
}

void Typing::stop()
{
    going_ = false;
    if (numbers().corrects()) // a correction ends with its field
        held_.use([](Tool& tool, Workbench& bench) { tool.cancel(bench); });
    if (readout_ && !held_.busy())
        readout_->releaseTyped(); // nothing is shown that it could hold
    steer();
}

bool Typing::releaseLocked()
{
    if (!readout_ || held_.busy() || !readout_->isLocked())
        return false;
    readout_.reset();
    follow();
    return true;
}

void Typing::hold(Pointer& pointer) const
{
    if (!readout_ || (!held_.busy() && !readout_->holds()))
        return;
    const app::GestureEnd end = readout_->result(pointer.steered);
    pointer.position = end.point;
    pointer.numbers = end.numbers;
    pointer.held = readout_->holds();
}

void Typing::steer()
{
    if (readout_ && held_.pointer) {
        hold(*held_.pointer);
        held_.use([this](Tool& tool, Workbench& bench) { tool.move(*held_.pointer, bench); });
    }
    emit changed();
}

/// What was typed ends with the gesture, or the step of it, for which it was typed.
void Typing::follow()
{
    const auto gauge = numbers().gauge(held_.bench());
    if ((!gauge && !readout_) || (gauge && readout_ && readout_->follow(*gauge)))
        return;
    going_ = false;
    readout_.reset();
    if (gauge)
        readout_.emplace(*gauge);
    emit changed();
}

} // namespace ui

#include "moc_typing.cpp"

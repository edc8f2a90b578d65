// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/gesture_steps.h"

#include "ui/look/text.h"

#include <algorithm>
#include <utility>

namespace ui {

constexpr int growthTold = 100; // milliseconds

GestureSteps::GestureSteps(HeldTool& held, Typing& typing)
    : held_(held), typing_(typing), known_(now())
{
    growing_.setSingleShot(true);
    growing_.setInterval(growthTold);
    connect(&growing_, &QTimer::timeout, this, &GestureSteps::changed);
    connect(&held, &HeldTool::chosen, this, &GestureSteps::changed);
    connect(&held, &HeldTool::used, this, &GestureSteps::follow);
    connect(&held.session().history, &app::History::indexChanged, this, &GestureSteps::changed);
}

bool GestureSteps::canUndo() const
{
    return held_.as<HasSteps>().canTakeBack() || held_.session().history.canUndo();
}

// While a polyline is being drawn, redoing a later step of the history would put it before the
// corners.
bool GestureSteps::canRedo() const
{
    const auto& steps = held_.as<HasSteps>();
    return steps.canPutBack(held_.bench())
           || (!steps.canTakeBack() && held_.session().history.canRedo());
}

void GestureSteps::undo()
{
    if (held_.as<HasSteps>().canTakeBack())
        return held_.use([](Tool& tool, Workbench& bench) { tool.as<HasSteps>().takeBack(bench); });
    if (!held_.busy())
        return held_.session().history.undo();
    if (typing_.going())
        typing_.stop();
    held_.cancel();
}

void GestureSteps::redo()
{
    if (held_.as<HasSteps>().canPutBack(held_.bench()))
        held_.use([](Tool& tool, Workbench& bench) { tool.as<HasSteps>().putBack(bench); });
    else if (!held_.busy())
        held_.session().history.redo();
}

void GestureSteps::goTo(int index)
{
    app::Session& session = held_.session();
    // What is being drawn becomes a step, which would take the place of those that are undone.
    if (held_.as<HasSteps>().canTakeBack() && index > session.history.index()) {
        emit session.refused(Text::tr("Finish the object that you are drawing first (Enter)."));
        return;
    }
    held_.end();
    session.history.setIndex(std::min(index, session.history.count()));
}

QString GestureSteps::undoText() const
{
    const auto& steps = held_.as<HasSteps>();
    return steps.canTakeBack() ? steps.stepText() : held_.session().history.undoText();
}

QString GestureSteps::redoText() const
{
    const auto& steps = held_.as<HasSteps>();
    return steps.canPutBack(held_.bench()) ? steps.stepText() : held_.session().history.redoText();
}

GestureSteps::Known GestureSteps::now() const
{
    return {canUndo(), canRedo(), held_.as<HasSteps>().canTakeBack(),
            held_.as<HasUnfinished>().unfinishedPoints()};
}

// Receivers copy the whole object being drawn, which would be slow for each point of a long
// freehand line.
void GestureSteps::follow()
{
    const Known before = std::exchange(known_, now());
    if (known_ == before)
        return;
    Known grown = before;
    grown.points = known_.points;
    const bool grows = known_ == grown && !known_.takeBack && known_.points > before.points;
    if (!grows) {
        growing_.stop();
        emit changed();
    } else if (!growing_.isActive()) {
        growing_.start();
    }
}

} // namespace ui

#include "moc_gesture_steps.cpp"

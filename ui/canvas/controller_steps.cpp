// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/controller.h"
#include "ui/look/text.h"

#include <algorithm>

// Undo and redo, which act on the tool during a gesture of several steps.

namespace ui {

bool Controller::canUndo() const
{
    return tool_->as<HasSteps>().canTakeBack() || session_.history.canUndo();
}

// While a polyline is being drawn, redoing a later step of the history would put it before the
// corners.
bool Controller::canRedo() const
{
    return tool_->as<HasSteps>().canPutBack(bench_)
           || (!tool_->as<HasSteps>().canTakeBack() && session_.history.canRedo());
}

void Controller::undo()
{
    if (tool_->as<HasSteps>().canTakeBack())
        withTool([&] { tool_->as<HasSteps>().takeBack(bench_); });
    else if (tool_->busy())
        cancelGesture();
    else
        session_.history.undo();
}

void Controller::cancelGesture()
{
    if (typing_)
        stopTyping();
    if (tool_->busy())
        withTool([&] { tool_->cancel(bench_); });
}

void Controller::redo()
{
    if (tool_->as<HasSteps>().canPutBack(bench_))
        withTool([&] { tool_->as<HasSteps>().putBack(bench_); });
    else if (!tool_->busy())
        session_.history.redo();
}

void Controller::goToStep(int index)
{
    // What is being drawn becomes a step, which would take the place of those that are undone.
    if (tool_->as<HasSteps>().canTakeBack() && index > session_.history.index()) {
        emit session_.refused(Text::tr("Finish the object that you are drawing first (Enter)."));
        return;
    }
    endGesture();
    session_.history.setIndex(std::min(index, session_.history.count()));
}

QString Controller::undoText() const
{
    return tool_->as<HasSteps>().canTakeBack() ? tool_->as<HasSteps>().stepText()
                                               : session_.history.undoText();
}

QString Controller::redoText() const
{
    return tool_->as<HasSteps>().canPutBack(bench_) ? tool_->as<HasSteps>().stepText()
                                                    : session_.history.redoText();
}

Controller::Steps Controller::steps() const
{
    return {canUndo(), canRedo(), tool_->as<HasSteps>().canTakeBack(),
            tool_->as<HasUnfinished>().unfinishedPoints()};
}

// Receivers copy the whole object being drawn, which would be slow for each point of a long
// freehand line.
void Controller::tellSteps(const Steps& before)
{
    const Steps now = steps();
    Steps grown = before;
    grown.points = now.points;
    const bool following = now == grown && !now.takeBack && now.points > before.points;
    if (now == before)
        return;
    if (following && !growing_.isActive())
        growing_.start();
    if (following)
        return;
    growing_.stop();
    emit stepsChanged();
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/units.h"
#include "ui/canvas/controller.h"
#include "ui/look/text.h"

#include <utility>

// The current tool.

namespace ui {

void Controller::setTool(std::string_view key)
{
    const ToolInfo* info = findTool(key);
    if (!info)
        return;
    if (tool_) {
        tool_->end(bench_);
        tool_->as<TakenUp>().putAway(bench_);
    }
    tool_ = info->make();
    toolInfo_ = info;
    tool_->as<TakenUp>().takeUp(bench_);
    snap_.reset();
    typing_ = false;
    readout_.reset(); // the numbers were for the other tool
    followGauge();
    emit readoutChanged();
    emit stepsChanged();
    emit toolChanged();
    emit hintChanged();
    emit changed();
}

// New objects must not be added to a locked or hidden layer.
bool Controller::mayDraw() const { return !toolInfo_->draws() || app::mayAddObjects(session_); }

QString Controller::hint() const
{
    if (!mayDraw())
        return Text::tr("The layer %1 is locked or hidden. Select another layer, or unlock and "
                        "show this one.")
            .arg(app::nameForNew(session_));
    if (pointer_ && tagAt({pointer_->screen.x, pointer_->screen.y}))
        return Text::tr("Click: choose this clip window. Right click: its menu.");
    const QString now = tool_->hint(bench_);
    return now.isEmpty() ? toolInfo_->hint : now;
}

QCursor Controller::cursor() const
{
    if (panningFrom_)
        return Qt::ClosedHandCursor;
    if (space_)
        return Qt::OpenHandCursor;
    if (const QPointF at = pointer_ ? QPointF(pointer_->screen.x, pointer_->screen.y) : QPointF();
        pointer_ && (offeredHandle().contains(at) || tagAt(at)))
        return Qt::PointingHandCursor;
    if (!mayDraw())
        return Qt::ForbiddenCursor;
    const QCursor own = tool_->cursor(bench_);
    return snap_ && own.shape() == Qt::CrossCursor ? Qt::BlankCursor
                                                   : own; // the marker replaces it
}

void Controller::withTool(const std::function<void()>& call)
{
    const auto told = [this] { return std::pair(hint(), digitUse()); };
    const auto before = told();
    const Steps stepsBefore = steps();
    call();
    if (!bench_.nextTool.empty())
        setTool(std::exchange(bench_.nextTool, {}));
    navigation_.go(toolView_);
    followGauge();
    if (told() != before)
        emit hintChanged();
    tellSteps(stepsBefore);
    emit changed();
}

void Controller::endGesture()
{
    panningFrom_.reset();
    if (tool_->busy())
        withTool([&] { tool_->end(bench_); });
}

std::optional<app::ObjectInHand> Controller::pendingObject() const
{
    return tool_->as<HasUnfinished>().unfinished(bench_);
}

} // namespace ui

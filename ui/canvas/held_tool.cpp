// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/held_tool.h"

#include "app/session/units.h"
#include "ui/canvas/window_tags.h"
#include "ui/look/text.h"

#include <utility>

namespace ui {

HeldTool::HeldTool(app::Session& session, Navigation& navigation)
    : navigation_(navigation), toolView_(navigation.view()),
      paperLook_(lookOnPaper(session.display().darkPaper)),
      picking_(session.document, session.scene),
      snapper_(session.document, session.scene, picking_), bench_{session,    toolView_, picking_,
                                                                  paperLook_, snapper_,  snapNow_}
{
    connect(&navigation, &Navigation::moved, this, [this] { toolView_ = view(); });
    connect(&session, &app::Session::displayChanged, this,
            [this] { paperLook_ = lookOnPaper(this->session().display().darkPaper); });
    choose(tools().front().key);
}

// New objects must not be added to a locked or hidden layer.
bool HeldTool::mayDraw() const { return !info_->draws() || app::mayAddObjects(session()); }

QString HeldTool::hint() const
{
    if (!mayDraw())
        return Text::tr("The layer %1 is locked or hidden. Select another layer, or unlock and "
                        "show this one.")
            .arg(app::nameForNew(session()));
    if (const auto& at = pointer; at && tagAt({at->screen.x, at->screen.y}, *this))
        return Text::tr("Click: choose this clip window. Right click: its menu.");
    const QString now = tool_->hint(bench_);
    return now.isEmpty() ? info_->hint : now;
}

void HeldTool::choose(std::string_view key)
{
    const ToolInfo* info = findTool(key);
    if (!info)
        return;
    if (tool_) {
        tool_->end(bench_);
        tool_->as<TakenUp>().putAway(bench_);
    }
    tool_ = info->make();
    info_ = info;
    tool_->as<TakenUp>().takeUp(bench_);
    emit chosen();
}

void HeldTool::use(const std::function<void(Tool&, Workbench&)>& call)
{
    call(*tool_, bench_);
    if (!bench_.nextTool.empty())
        choose(std::exchange(bench_.nextTool, {}));
    navigation_.go(toolView_);
    emit used();
}

void HeldTool::end()
{
    if (busy())
        use([](Tool& tool, Workbench& bench) { tool.end(bench); });
}

void HeldTool::cancel()
{
    if (busy())
        use([](Tool& tool, Workbench& bench) { tool.cancel(bench); });
}

void HeldTool::setSnapping(app::SnapTo to, bool on)
{
    snapTo_ = to;
    snaps_ = on;
    snapNow_ = on ? to : app::SnapTo::Nothing;
    emit snappingChanged();
}

} // namespace ui

#include "moc_held_tool.cpp"

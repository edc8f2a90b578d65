// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/canvas/navigation.h"
#include "ui/tools/tool_parts.h"

#include <functional>
#include <memory>
#include <optional>
#include <string_view>

namespace ui {

/// The chosen tool on its workbench, and the pointer at which it is held. A tool acts only within
/// use(), after which used() is told to all that follow it.
class HeldTool : public QObject {
    Q_OBJECT

public:
    HeldTool(app::Session& session, Navigation& navigation);

    app::Session& session() const { return bench_.session; }
    const app::View& view() const { return navigation_.view(); }
    const ToolInfo& info() const { return *info_; }
    const Tool& tool() const { return *tool_; }
    template <class Part>
    const Part& as() const
    {
        return tool().as<Part>();
    }
    bool busy() const { return tool_->busy(); } ///< a gesture of the tool is in progress
    bool mayDraw() const; ///< false: new objects would come into a locked or hidden layer
    QString hint() const; ///< what the pointer does there, or what is missing
    const Workbench& bench() const { return bench_; }
    std::optional<Pointer> pointer; ///< over the canvas; empty: it has left

    void choose(std::string_view key); ///< the current tool begins anew
    void use(const std::function<void(Tool&, Workbench&)>& call);
    void end();    ///< ends its gesture, and keeps what is complete
    void cancel(); ///< discards its gesture

    /// The kinds of places that the pointer snaps to, while snapping is on.
    app::SnapTo snapping() const { return snapTo_; }
    bool snaps() const { return snaps_; } ///< whether snapping is on
    void setSnapping(app::SnapTo to, bool on);

signals:
    void chosen(); ///< also if the same tool begins anew
    void used();
    void snappingChanged();

private:
    Navigation& navigation_;
    app::View toolView_; ///< the view that tools change; compared with the real one after each call
    Look paperLook_;     ///< of what lies on the drawing
    app::Picking picking_;
    app::Snapper snapper_;
    app::SnapTo snapTo_ = app::SnapTo::usual();
    bool snaps_ = true;
    app::SnapTo snapNow_ = snapTo_; ///< Nothing while snapping is off
    Workbench bench_;
    const ToolInfo* info_ = nullptr;
    std::unique_ptr<Tool> tool_;
};

} // namespace ui

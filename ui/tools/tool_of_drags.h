// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/drag.h"
#include "ui/tools/tool_parts.h"

#include <vector>

namespace ui {

/// A tool of several drags, of which at most one goes on. It begins with the press, on a handle, or
/// when the pointer moves; otherwise the press was a click.
class ToolOfDrags : public Tool, public TypesNumbers, public Snaps {
public:
    void move(const Pointer& pointer, Workbench& bench) override;
    void release(const Pointer& pointer, Workbench& bench) override;
    void cancel(Workbench& bench) override;
    bool busy() const override { return pressed_ || going(); }
    void paint(QPainter& painter, const Workbench& bench) const override;

    std::optional<app::Gauge> gauge(const Workbench& bench) const override;
    void accept(const app::GestureEnd& end, Workbench& bench) override;
    void reopen(Workbench& bench) override;
    bool corrects() const override;
    void limit(app::SnapQuery& query) const override;
    const app::MovedSnap* snapped() const override
    {
        return going() ? going()->snapped() : nullptr;
    }

protected:
    /// `drags` are members of the tool.
    explicit ToolOfDrags(std::vector<Drag*> drags) : drags_(std::move(drags)) {}

    virtual void look(const Pointer& pointer,
                      Workbench& bench) = 0;      ///< no gesture: what is hovered
    virtual void startDrag(Workbench& bench) = 0; ///< the pointer has left the place of the press
    virtual void click(const Pointer& pressed, Workbench& bench) = 0;
    Drag* going() const; ///< null: none
    void
    forgetSteps(Workbench& bench); ///< the next action begins: numbers are not for the last one

    std::optional<Pointer> pressed_; ///< where the button was pressed; empty: it is up

private:
    std::vector<Drag*> drags_;
};

} // namespace ui

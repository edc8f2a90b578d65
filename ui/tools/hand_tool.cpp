// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/tool_parts.h"

namespace ui {
namespace {

/// Drags the view.
class HandTool final : public Tool, public Snaps {
public:
    void press(const Pointer& pointer, Workbench&) override { from_ = pointer.screen; }
    void move(const Pointer& pointer, Workbench& bench) override
    {
        if (!from_)
            return;
        bench.view.pan(pointer.screen - *from_);
        from_ = pointer.screen;
    }
    void release(const Pointer&, Workbench&) override { from_.reset(); }
    void cancel(Workbench&) override { from_.reset(); }
    bool busy() const override { return from_.has_value(); }
    QCursor cursor(const Workbench&) const override
    {
        return from_ ? Qt::ClosedHandCursor : Qt::OpenHandCursor;
    }
    void limit(app::SnapQuery& query) const override { query.to = app::SnapTo::Nothing; }

private:
    std::optional<app::Point> from_;
};

} // namespace

std::unique_ptr<Tool> makeHandTool() { return std::make_unique<HandTool>(); }

} // namespace ui

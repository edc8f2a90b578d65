// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/shape_drawing.h"
#include "ui/tools/tool_parts.h"

namespace ui {
namespace {

constexpr double step = 2;

/// Zooms to a dragged rectangle; a click zooms in, with Alt out.
class ZoomTool final : public Tool, public Snaps {
public:
    void press(const Pointer& pointer, Workbench&) override { from_ = to_ = pointer; }
    void move(const Pointer& pointer, Workbench&) override { to_ = pointer; }
    void release(const Pointer& pointer, Workbench& bench) override
    {
        if (!from_)
            return;
        if (dragged(from_->screen, pointer))
            bench.view.fit(app::between(from_->raw, pointer.raw), 0);
        else
            bench.view.zoomAt(pointer.screen,
                              pointer.modifiers & Qt::AltModifier ? 1 / step : step);
        from_.reset();
    }
    void cancel(Workbench&) override { from_.reset(); }
    bool busy() const override { return from_.has_value(); }
    void limit(app::SnapQuery& query) const override { query.to = app::SnapTo::Nothing; }
    void paint(QPainter& painter, const Workbench& bench) const override
    {
        if (!from_)
            return;
        painter.setPen(QPen(bench.look.selection, 1));
        painter.drawRect(QRectF(bench.onScreen(from_->raw), bench.onScreen(to_.raw)).normalized());
    }

private:
    std::optional<Pointer> from_;
    Pointer to_{};
};

} // namespace

std::unique_ptr<Tool> makeZoomTool() { return std::make_unique<ZoomTool>(); }

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/drag.h"
#include "ui/tools/grabbed_nodes.h"

namespace ui {

/// Drags the selected nodes, a handle, or a curved segment, which it bends. Shows the paths as the
/// drag would leave them.
class NodeDrag final : public Drag {
public:
    void start(const GrabbedNodes& grabbed, const Pointer& pressed, Workbench& bench);
    bool going() const override { return paths_.has_value(); }
    void proceed(const Pointer& pointer, Workbench& bench) override;
    bool finish(const Pointer& pointer, Workbench& bench) override;
    void cancel(Workbench&) override { paths_.reset(); }
    void paint(QPainter& painter, const Workbench& bench) const override;
    std::optional<app::Gauge> gauge(const Workbench& bench) const override;
    void accept(const app::GestureEnd& end, Workbench& bench) override;
    void limit(app::SnapQuery& query) const override
    {
        query.without = moving_;
        query.parts = &fixed_;
    }

private:
    enum class What : std::uint8_t { Nodes, Handle, Bend };
    void follow(const app::Point& to, Qt::KeyboardModifiers modifiers, Workbench& bench);
    void findFixed(const Pointer& pressed, Workbench& bench);
    void push(Workbench& bench);

    What what_ = What::Nodes;
    GrabbedNodes grabbed_;
    std::optional<app::NodePath> paths_; ///< as the drag would leave them
    app::ObjectRanges moving_;           ///< the objects that it changes,
    std::vector<app::Subpath> fixed_;    ///< and what stays of them
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/window_kinds.h"
#include "app/session/window_steps.h"
#include "ui/tools/tool.h"

#include <utility>

namespace ui {

/// Draws a clip window with the session's window pen, as other tools draw objects: from one point
/// to another, or corner by corner. The session's preview holds the window so far.
std::unique_ptr<Tool> makeWindowDrawing(const app::WindowKind& kind);
/// Whether numbers typed now would change the window that it has drawn, from one point to another.
bool canCorrect(const Tool& drawing, const Workbench& bench);

/// The window that a gesture draws, in the session's preview. It is the one that tools act on; if
/// the gesture is cancelled, the one before it is chosen again.
class DrawnWindow {
public:
    void show(const app::WindowShape& shape, Workbench& bench)
    {
        app::Session& session = bench.session;
        auto [windows, number] = app::withDrawn(session, shape);
        if (!before_)
            before_ = session.windowNumber().value_or(0);
        session.chooseWindow(number);
        session.setPreview({.windows = std::move(windows), .drag = app::Preview::Drag::Sizing});
    }
    /// The command is pushed before the preview ends, so that the window does not jump.
    void keep(const app::WindowShape& shape, Workbench& bench)
    {
        app::drawWindow(bench.session, shape);
        before_.reset();
        bench.session.setPreview({});
        kept_ = bench.session.windowNumber().value_or(0);
    }
    /// Chooses the window that was kept last, when it is restored after a correction.
    void choose(Workbench& bench) { bench.session.chooseWindow(kept_); }
    void drop(Workbench& bench)
    {
        bench.session.setPreview({});
        if (const auto number = std::exchange(before_, std::nullopt))
            bench.session.chooseWindow(*number);
    }

private:
    std::optional<std::size_t> before_; ///< the window that was chosen
    std::size_t kept_ = 0;
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/drawn_line.h"
#include "app/session/live_sheets.h"
#include "ui/canvas/canvas.h"
#include "ui/files/files.h"
#include "ui/look/look.h"

#include <random>

#include "tests/ui/test_window.h"
#include "tests/ui/window/plain_panels.h"

namespace ui {

/// What the widgets of a main window are made on: without the window, or those of a window. And
/// somebody who changes them at random.
class Desk {
    struct Own {
        PlainWindow frame; ///< also holds the settings
        app::Session session;
        app::DrawnLine drawn{session};
        app::LiveSheets sheets{session};
        Canvas canvas{session, Backend::Raster};
        Files files{session, frame.window, std::make_unique<PreparedAnswers>(frame.window)};
    };
    std::unique_ptr<Own> own_; ///< null: they are a window's
    MainWindow* window_ = nullptr;

public:
    explicit Desk(quint64 seed)
        : own_(std::make_unique<Own>()), session(own_->session), drawn(own_->drawn),
          sheets(own_->sheets), canvas(own_->canvas), random_(seed)
    {
        applyTheme(*qApp, Theme::Light);
        own_->frame.layout->restore();
    }
    Desk(quint64 seed, MainWindow& window)
        : window_(&window), session(window.session()), drawn(window.drawnLine()),
          sheets(window.sheets()), canvas(window.canvas()), random_(seed)
    {
    }

    // Only without a window.
    QMainWindow& frame() { return own_->frame.window; }
    PanelLayout& layout() { return *own_->frame.layout; }
    Files& files() { return own_->files; }

    void choose(const Workspace& workspace)
    {
        window_ ? window_->choose(workspace) : layout().choose(workspace);
    }
    /// A number from 0 to below `end`.
    int below(int end) { return int(random_() % quint64(end)); }
    bool likes(int one, int in) { return below(in) < one; }
    template <class List>
    auto& oneOf(List&& list)
    {
        return list[std::size_t(below(int(std::size(list))))];
    }
    std::mt19937_64& random() { return random_; }

    app::Session& session;
    app::DrawnLine& drawn;
    app::LiveSheets& sheets;
    Canvas& canvas; ///< the one that bars and panels belong to

private:
    std::mt19937_64 random_;
};

} // namespace ui

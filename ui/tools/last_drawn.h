// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/tool.h"

namespace ui {

/// The last gesture of a tool, while it can be opened again to change what it has drawn.
class LastDrawn {
public:
    struct Gesture {
        app::Point from, to;
        Qt::KeyboardModifiers modifiers;
    };

    /// The last step of the history was drawn by this gesture.
    void remember(const Gesture& gesture, const Workbench& bench);
    void forget() { gesture_.reset(); }
    /// Takes the drawn object back; empty: something else has happened since.
    std::optional<Gesture> reopen(Workbench& bench);
    bool isOpen() const { return open_; }
    /// Where the gesture that is open again ended.
    std::optional<app::Point> end() const;
    /// Nothing was changed: draws the object again.
    void restore(Workbench& bench);
    /// Something else is drawn instead.
    void discard() { open_ = false; }

private:
    static int stepsDone(const Workbench& bench);

    std::optional<Gesture> gesture_;
    int steps_ = 0;
    bool open_ = false;
};

} // namespace ui

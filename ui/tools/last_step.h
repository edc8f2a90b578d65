// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/tools/tool.h"

namespace ui {

/// The step of the history that a gesture has made, while it can be opened again to be made anew
/// with other numbers.
class LastStep {
public:
    LastStep() = default;
    ~LastStep() { QObject::disconnect(others_); }
    LastStep(const LastStep&) = delete;
    LastStep& operator=(const LastStep&) = delete;

    void remember(const Workbench& bench); ///< the history's last step
    void forget() { steps_.reset(); }
    /// Whether nothing else has happened since.
    bool canReopen(const Workbench& bench) const;
    /// Undoes the step. False: something else has happened since.
    bool reopen(Workbench& bench);
    bool isOpen() const { return open_; }
    void restore(Workbench& bench);   ///< nothing was changed: redoes the step
    void discard() { open_ = false; } ///< another step is made instead

private:
    std::optional<int> steps_; ///< the number of steps done after it
    bool open_ = false;
    QMetaObject::Connection others_; ///< to steps of others
};

} // namespace ui

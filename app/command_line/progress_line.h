// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/progress.h"

#include <QElapsedTimer>

namespace app {

/// Updates one line on standard error, "42 %, 12 s left", from half a second after its beginning to
/// its end; silent if standard error is not a terminal. One at a time.
class ProgressLine {
public:
    ProgressLine() { clock_.start(); }
    ~ProgressLine() { erase(); }
    Q_DISABLE_COPY_MOVE(ProgressLine)

    /// For a task during its lifetime; it never stops the task.
    Follower follower();
    void show(const Progress& progress);
    /// Erases the line that is shown, if any. Safe in a signal handler.
    static void erase();

private:
    QElapsedTimer clock_;
    int shown_ = -1; ///< in per cent
};

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace app {

/// While this object lives, removeUnfinished() removes the incomplete temporary file beside `path`.
/// At most one such object may exist at a time.
class Unfinished {
public:
    explicit Unfinished(const QString& path);
    ~Unfinished();
    Q_DISABLE_COPY_MOVE(Unfinished)
};

/// Called when a signal ends the process. Safe in a signal handler and on any thread.
void removeUnfinished();

} // namespace app

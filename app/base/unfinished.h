// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace app {

/// While it lives, removeUnfinished() removes the half of a file that lies beside `path` to replace
/// it. There may be one at a time.
class Unfinished {
public:
    explicit Unfinished(const QString& path);
    ~Unfinished();
    Q_DISABLE_COPY_MOVE(Unfinished)
};

/// For the end of the process by a signal; a handler or any thread may call it.
void removeUnfinished();

} // namespace app

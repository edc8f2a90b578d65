// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/experiment.h"

namespace app {

/// Updates one line on standard error, "42 %, 12 s left", during its lifetime; silent if standard
/// error is not a terminal.
class ProgressLine {
public:
    ~ProgressLine();
    void show(const Progress& progress);

private:
    int shown_ = -1; ///< in per cent
};

} // namespace app

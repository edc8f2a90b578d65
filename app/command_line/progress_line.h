// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/experiment.h"

namespace app {

/// Keeps one line on standard error up to date, "42 %, 12 s left", while it lives; silent where
/// that is no terminal.
class ProgressLine {
public:
    ~ProgressLine();
    void show(const Progress& progress);

private:
    int shown_ = -1; ///< per cent
};

} // namespace app

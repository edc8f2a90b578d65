// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/walk.h"

namespace app {

/// A step of a specimen's walk; the references must outlive the call.
struct WalkStep {
    const Specimen& specimen;
    const Walk& walk;
    std::size_t step;
};

} // namespace app

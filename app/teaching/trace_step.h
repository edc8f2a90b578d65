// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/narration.h"

namespace app {

/// A step of a traced line's trace; the references must outlive the call.
struct TraceStep {
    const TracedLine& tracedLine;
    const Narration& narration;
    std::size_t step;
};

} // namespace app

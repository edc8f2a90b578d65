// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/document/document.h"
#include "app/hard_cases/hard_case.h"
#include "app/teaching/narration.h"

// How other parts of the program use a hard case.

namespace app {

/// The traced line for the microscope, y up.
TracedLine tracedLineOf(const HardCase& hard, const Variant& variant);

/// A drawing of the line with its window, with exactly the same numbers, so that y points down. Or
/// a sentence that says why this is impossible.
Result<Document> documentOf(const HardCase& hard);

/// The variant that is shown first: one that never ends, otherwise the one farthest outside the
/// window, otherwise the first that fails; if none fails, the first of all.
Variant firstToLookAt(const HardCase& hard);

} // namespace app

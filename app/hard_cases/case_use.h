// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/document/document.h"
#include "app/hard_cases/hard_case.h"
#include "app/teaching/walk.h"

// What can be done with a hard case elsewhere in the program.

namespace app {

/// For the microscope, y up.
Specimen specimenOf(const HardCase& hard, const Variant& variant);

/// A drawing of the line, with its window; the very same numbers, so that y points down there. Or
/// the sentence why there is none.
Result<Document> documentOf(const HardCase& hard);

/// The variant that is shown first: one that never ends, else the one farthest outside the window,
/// else the first that fails; if none fails, the first of all.
Variant firstToLookAt(const HardCase& hard);

} // namespace app

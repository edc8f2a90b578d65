// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/length.h"
#include "app/base/result.h"

#include <string_view>

namespace app {

/// The unit of numbers without a unit, and the size of the drawing's user unit.
struct Scale {
    Unit unit = Unit::User;
    double millimetresPerUnit = 1;
};

/// Evaluates a length as people type it: numbers with or without a unit ("10mm", "1in"), + - * /,
/// brackets and spaces, in the C locale. Examples: "10+5", "3*25mm", "(1in+5)/2"; "1/2in" is half
/// an inch. The result is finite and in `scale.unit`. The error is the end of a sentence that says
/// what is wrong with the text: "division by zero".
Result<double> evaluated(std::string_view text, const Scale& scale);

} // namespace app

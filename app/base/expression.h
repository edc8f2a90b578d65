// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/length.h"
#include "app/base/result.h"

#include <string_view>

namespace app {

/// The unit that a number without one is in, and the size of the drawing's unit.
struct Scale {
    Unit unit = Unit::User;
    double millimetresPerUnit = 1;
};

/// A length as people type it: numbers with or without a unit ("10mm", "1in"), + - * /, brackets
/// and spaces, in the C locale. "10+5", "3*25mm", "(1in+5)/2"; "1/2in" is half an inch. The result
/// is in `scale.unit`, finite; or the error says what is wrong with the text, as the end of a
/// sentence: "division by zero".
Result<double> evaluated(std::string_view text, const Scale& scale);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace app::formulas {

/// A pseudo-code with one fault in a formula, made on purpose.
struct Altered {
    std::string line;   ///< as it stood there, without indentation
    std::string change; ///< where in it, and what stands there now
    std::string code;   ///< all of it, altered
};

/// Every fault of these kinds that still reads: another operator, bound, operand, strictness,
/// truth or bit in a formula, and two neighbouring lines exchanged.
std::vector<Altered> alterationsOf(std::string_view code);

} // namespace app::formulas

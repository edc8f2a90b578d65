// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <string_view>

namespace app::csv {

/// How the fields of a table are separated and its numbers are written.
struct Dialect {
    char separator = ','; ///< or anyBlanks
    /// Whether a comma in a number is a decimal comma.
    bool hasDecimalCommas() const { return separator != ','; }
};

/// The dialect of a table with this first record, which may be a header.
Dialect dialectOf(std::string_view record, std::size_t line);

/// A number of at most 1e300, with blanks around it.
std::optional<double> coordinateOf(std::string_view field, const Dialect& dialect);

/// Whether a field is a well-formed number, but beyond that range.
bool isTooLarge(std::string_view field);

std::string_view trimmed(std::string_view field); ///< without the blanks around it

} // namespace app::csv

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace app {

/// Appends the shortest decimal text that reads back bit for bit, without an exponent; -0 is "0".
/// The one way that numbers reach a file. The number is finite, here and below.
void appendNumber(std::string& text, double number);

/// With `precision` decimals (trailing zeros left out), rounded to nearest, then moved by whole
/// units of the last decimal until low <= the decimals' value <= high, if any such decimal exists.
void appendNumber(std::string& text, double number, int precision, double low, double high);

/// A C-locale number (exponents allowed) that is finite; nothing otherwise. Takes the whole text.
std::optional<double> parseNumber(std::string_view text);

} // namespace app

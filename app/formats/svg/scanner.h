// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace app::svg {

constexpr std::string_view blanks = " \t\r\n\f";

std::string_view trimmed(std::string_view text);
/// Only ASCII letters, as CSS and SVG compare their keywords.
bool equalsIgnoringCase(std::string_view a, std::string_view b);

/// Reads the small languages inside attributes (path data, transforms, points) from the left.
class Scanner {
public:
    explicit Scanner(std::string_view text) : rest_(text) {}

    void skipBlanks();
    void skipSeparator(); ///< blanks, at most one comma, blanks
    bool atEnd() const { return rest_.empty(); }
    char peek() const { return rest_.empty() ? '\0' : rest_.front(); }
    bool take(char c);
    std::string_view word(); ///< ASCII letters; may be empty
    std::string_view rest() const { return rest_; }

    /// A number at this very place, or nothing and nothing is taken. What is written as a number
    /// but has no finite value (NaN, 1e400) throws Refused: a drawing never contains such.
    std::optional<double> number();
    std::optional<bool> flag(); ///< one character, '0' or '1', as arcs have

private:
    std::string_view rest_;
};

} // namespace app::svg

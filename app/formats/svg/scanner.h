// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>
#include <vector>

namespace app::svg {

constexpr std::string_view blanks = " \t\r\n\f";

std::string_view trimmed(std::string_view text);
/// Ignores the case of ASCII letters only, as CSS and SVG do for keywords.
bool equalsIgnoringCase(std::string_view a, std::string_view b);
bool isNameCharacter(char c); ///< of CSS: a letter, digit, - or _, and all beyond ASCII

/// Takes the next part between separators, of which those in brackets do not count; may be empty.
std::string_view takeWord(std::string_view& text, std::string_view separators);

/// The parts of a text between blanks; "calc(1px + 2px)" is one.
std::vector<std::string_view> wordsOf(std::string_view text);

/// Parses the small languages inside attributes (path data, transforms, points) from left to right.
class Scanner {
public:
    explicit Scanner(std::string_view text) : rest_(text) {}

    void skipBlanks();
    void skipSeparator(); ///< blanks, at most one comma, blanks
    bool atEnd() const { return rest_.empty(); }
    char peek() const { return rest_.empty() ? '\0' : rest_.front(); }
    bool take(char c);
    std::string_view word(); ///< reads ASCII letters; may be empty
    std::string_view rest() const { return rest_; }

    /// Reads a number that begins exactly here; empty if there is none, and then nothing is
    /// consumed. Throws Refused for a number without a finite value (NaN, 1e400): a drawing never
    /// contains one.
    std::optional<double> number();
    std::optional<bool> flag(); ///< reads one character, '0' or '1', as in arcs

private:
    std::string_view rest_;
};

} // namespace app::svg

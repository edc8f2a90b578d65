// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <string_view>

namespace app::svg {

/// The properties of letters that Clearcut evaluates; all are inherited. The strings are views, as
/// in Properties.
struct TextStyle {
    enum class Anchor : std::uint8_t { Start, Middle, End };
    enum class Case : std::uint8_t { AsWritten, Upper, Lower };
    static constexpr std::uint8_t underline = 1, overline = 2, lineThrough = 4;

    std::string_view families{}; ///< "Arial, sans-serif"
    int weight = 400;
    bool italic = false, smallCapitals = false, kerning = true;
    double letterSpacing = 0, wordSpacing = 0; ///< in user units
    Anchor anchor = Anchor::Start;
    Case letterCase = Case::AsWritten;
    bool rightToLeft = false;
    bool vertical = false;        ///< written from top to bottom
    bool keepsBlanks = false;     ///< of CSS; xml:space says the same
    std::string_view baseline{};  ///< "middle": the line of the letters that lies on the baseline
    std::uint8_t lines = 0;       ///< under, over and through the letters
    std::uint8_t linesAround = 0; ///< those of elements around
    std::string_view notEvaluated{}; ///< a property that changes letters, and has a value that does
};

} // namespace app::svg

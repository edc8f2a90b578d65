// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string_view>

namespace app::svg {

/// What a word inside calc() is worth; empty: it is not understood. `isNumber` is set for a plain
/// number, which may be a factor.
struct CalcValue {
    double value = 0;
    bool isNumber = false;
};
class CalcWords {
public:
    virtual ~CalcWords() = default;
    virtual std::optional<CalcValue> valueOf(std::string_view word) const = 0;
};

bool isCalc(std::string_view text); ///< whether it begins with calc(, min(, max( or clamp(

/// The value of calc(), min(), max() or clamp(), nested at most 30 deep. Empty if the text is not
/// understood, multiplies lengths or divides by zero or a length.
std::optional<CalcValue> calculated(std::string_view text, const CalcWords& words);

} // namespace app::svg

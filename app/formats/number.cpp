// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/number.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace app {
namespace {

// The longest fixed text of a double: 309 digits before the point, 1074 after it, sign and point.
using Buffer = std::array<char, 1400>;

void appendTrimmed(std::string& text, std::string_view number)
{
    if (number.find('.') != std::string_view::npos) {
        number = number.substr(0, number.find_last_not_of('0') + 1);
        if (number.ends_with('.'))
            number.remove_suffix(1);
    }
    text += number == "-0" ? std::string_view("0") : number;
}

} // namespace

void appendNumber(std::string& text, double number)
{
    Buffer buffer;
    const auto end = std::to_chars(buffer.begin(), buffer.end(), number, std::chars_format::fixed).ptr;
    appendTrimmed(text, {buffer.data(), std::size_t(end - buffer.data())});
}

void appendNumber(std::string& text, double number, int precision, double low, double high)
{
    Buffer buffer;
    const auto format = [&](double x) {
        const auto end = std::to_chars(buffer.begin(), buffer.end(), x, std::chars_format::fixed, precision).ptr;
        return std::string_view(buffer.data(), std::size_t(end - buffer.data()));
    };
    const auto value = [](std::string_view s) { return parseNumber(s).value_or(0); };
    const double step = std::pow(10.0, -precision);
    std::string_view best = format(number);
    if (value(best) > high)
        best = format(number - step);
    else if (value(best) < low)
        best = format(number + step);
    if (value(best) > high || value(best) < low)
        best = format(number); // no such decimal: the window is thinner than one
    appendTrimmed(text, best);
}

std::optional<double> parseNumber(std::string_view text)
{
    if (text.starts_with('+'))
        text.remove_prefix(1);
    double number = 0;
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, number);
    if (error != std::errc{} || end != last || !std::isfinite(number))
        return std::nullopt;
    return number;
}

} // namespace app

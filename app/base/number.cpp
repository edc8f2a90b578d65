// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/number.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <charconv>
#include <cmath>

namespace app {
namespace {

// The longest fixed text of a double: 309 digits before the point, 1074 after it, sign and point.
using Buffer = std::array<char, 1400>;
constexpr int mostDecimals = 1074;

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
    assert(std::isfinite(number));
    Buffer buffer;
    const auto end =
        std::to_chars(buffer.begin(), buffer.end(), number, std::chars_format::fixed).ptr;
    appendTrimmed(text, {buffer.data(), std::size_t(end - buffer.data())});
}

QString shortestText(double number)
{
    std::string text;
    appendNumber(text, number);
    return QString::fromStdString(text);
}

void appendNumber(std::string& text, double number, int precision, double low, double high)
{
    assert(std::isfinite(number));
    precision = std::clamp(precision, 0, mostDecimals);
    Buffer buffer;
    const auto rounded = [&](double x) {
        const auto end =
            std::to_chars(buffer.begin(), buffer.end(), x, std::chars_format::fixed, precision).ptr;
        return std::string_view(buffer.data(), std::size_t(end - buffer.data()));
    };
    const auto value = [](std::string_view s) { return parseNumber(s).value_or(0); };
    const auto first = value(rounded(number));
    if (first < low || first > high) {
        // The last decimal inside a bound is the rounded bound or the decimal before that.
        const double bound = first > high ? high : low;
        const double inward = std::pow(10.0, -precision) * (first > high ? -1 : 1);
        for (const double candidate : {bound, bound + inward / 2, bound + inward}) {
            const auto decimals = rounded(candidate);
            if (value(decimals) < low || value(decimals) > high)
                continue;
            appendTrimmed(text, decimals);
            return;
        }
    }
    appendTrimmed(text, rounded(number)); // in bounds, or no decimal lies between them
}

std::optional<double> parseNumber(std::string_view text)
{
    if (text.starts_with('+') && !text.starts_with("+-"))
        text.remove_prefix(1);
    double number = 0;
    const char* const last = text.data() + text.size();
    const auto [end, error] = std::from_chars(text.data(), last, number);
    if (error != std::errc{} || end != last || !std::isfinite(number))
        return std::nullopt;
    return number;
}

QString inCLocale(QString text, const QLocale& locale)
{
    text = text.simplified();
    text.replace(u'\u2212', u'-').replace(u'\u00d7', u'*').replace(u'\u00f7', u'/');
    text.remove(locale.groupSeparator());
    text.replace(locale.decimalPoint(), QStringLiteral("."));
    return text;
}

Result<double> typedLength(const QString& text, const Scale& scale, const QLocale& locale)
{
    return evaluated(inCLocale(text, locale).toStdString(), scale);
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/given_value.h"

#include "app/base/number.h"
#include "app/base/text.h"
#include "app/command_line/command.h"

#include <algorithm>
#include <charconv>

namespace app {
namespace {

// Whether a number or a length is beyond the range of calculation: its form is correct.
bool isTooLarge(const QString& text)
{
    const std::string all = text.trimmed().toStdString();
    const char* const first = all.data() + (all.starts_with('+') ? 1 : 0);
    double value = 0;
    const auto [end, error] = std::from_chars(first, all.data() + all.size(), value);
    const std::string_view number(first, std::size_t(end - first));
    // A number that is too small has the same error code.
    if (error != std::errc::result_out_of_range || number.find("e-") != number.npos
        || number.find("E-") != number.npos)
        return false;
    return parseLength('0' + std::string(end)).has_value();
}

} // namespace

void refuse(const GivenValue& value, const QString& expected)
{
    throw WrongUsage{Text::tr("--%1 %2: give %3.").arg(value.option, value.text, expected)};
}

void refuseNumbers(const GivenValue& value, const QString& expected)
{
    const QStringList parts = value.text.split(u',');
    const auto found = std::ranges::find_if(parts, isTooLarge);
    if (found == parts.end())
        refuse(value, expected);
    throw WrongUsage{Text::tr("--%1 %2: “%3” is too large; numbers go up to 1.79e308.")
                         .arg(value.option, value.text, found->trimmed())};
}

std::array<double, 4> fourNumbers(const GivenValue& value, const QString& numbers,
                                  const QString& names)
{
    std::array<double, 4> all{};
    const QStringList parts = numbers.split(u',');
    bool fits = parts.size() == 4;
    for (qsizetype i = 0; fits && i < 4; ++i) {
        const auto number = parseNumber(parts[i].trimmed().toStdString());
        fits = number.has_value();
        all[std::size_t(i)] = number.value_or(0);
    }
    if (!fits)
        refuseNumbers(value, Text::tr("four numbers %1 such as -100,-75,100,75").arg(names));
    return all;
}

std::vector<Length> lengthsOf(const GivenValue& value, const QString& numbers,
                              const QString& expected)
{
    std::vector<Length> lengths;
    for (const QString& part : numbers.split(u',')) {
        const auto length = parseLength(part.toStdString());
        if (!length || length->unit == Unit::Percent)
            refuseNumbers(value, expected);
        lengths.push_back(*length);
    }
    return lengths;
}

} // namespace app

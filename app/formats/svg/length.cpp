// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/length.h"

#include "app/base/length.h"
#include "app/formats/svg/calc.h"
#include "app/formats/svg/scanner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace app::svg {

namespace {

/// The words of a calculation with lengths.
class LengthWords final : public CalcWords {
public:
    LengthWords(const Lengths& lengths, double of) : lengths_(lengths), of_(of) {}
    std::optional<CalcValue> valueOf(std::string_view word) const override
    {
        const auto value = lengths_.parse(word, of_);
        return value ? std::optional(CalcValue{*value, isPlainNumber(word)}) : std::nullopt;
    }

private:
    static bool isPlainNumber(std::string_view word)
    {
        Scanner in(word);
        return in.number() && in.atEnd();
    }

    const Lengths& lengths_;
    double of_;
};

} // namespace

std::optional<double> Lengths::parse(std::string_view text, double of) const
{
    if (isCalc(text)) {
        const auto result = calculated(text, LengthWords(*this, of));
        return result ? std::optional(result->value) : std::nullopt;
    }
    Scanner in(trimmed(text));
    const auto number = in.number();
    if (!number)
        return std::nullopt;
    if (in.atEnd())
        return number;
    const auto suffix = in.rest();
    if (const auto size = unit(suffix))
        return *number * *size;
    const auto known = std::ranges::find_if(units(), [&](const UnitInfo& info) {
        return info.inSvg && equalsIgnoringCase(info.suffix, suffix);
    });
    if (known == units().end())
        return std::nullopt;
    return toUserUnits({*number, known->unit}, pixel, of);
}

std::optional<double> Lengths::unit(std::string_view suffix) const
{
    struct Row {
        std::string_view name;
        double size;
    };
    const auto [least, most] = std::minmax(screen.x, screen.y);
    for (const Row& row : {Row{"em", fontSize}, Row{"ex", fontSize / 2}, Row{"ch", fontSize / 2},
                           Row{"ic", fontSize}, Row{"rem", rootFontSize}, Row{"q", 0.25 / pixel},
                           Row{"vw", screen.x / 100}, Row{"vh", screen.y / 100},
                           Row{"vmin", least / 100}, Row{"vmax", most / 100}})
        if (equalsIgnoringCase(row.name, suffix))
            return row.size;
    return std::nullopt;
}

bool lacksUnit(std::string_view text)
{
    Scanner in(trimmed(text));
    const auto number = in.number();
    return number && *number != 0 && in.atEnd();
}

std::optional<double> degreesOf(std::string_view unit)
{
    struct AngleUnit {
        std::string_view name;
        double degrees;
    };
    constexpr std::array all{AngleUnit{"", 1}, AngleUnit{"deg", 1}, AngleUnit{"grad", 0.9},
                             AngleUnit{"rad", 180 / std::numbers::pi}, AngleUnit{"turn", 360}};
    const auto found = std::ranges::find_if(
        all, [&](const AngleUnit& each) { return equalsIgnoringCase(each.name, unit); });
    return found == all.end() ? std::nullopt : std::optional(found->degrees);
}

double Lengths::diagonal() const
{
    return std::hypot(viewport.x, viewport.y) / std::numbers::sqrt2;
}

} // namespace app::svg

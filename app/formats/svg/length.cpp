// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/length.h"

#include "app/base/length.h"
#include "app/formats/svg/scanner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace app::svg {

std::optional<double> Lengths::parse(std::string_view text, double of) const
{
    Scanner in(trimmed(text));
    const auto number = in.number();
    if (!number)
        return std::nullopt;
    if (in.atEnd())
        return number;
    const auto suffix = in.rest();
    if (equalsIgnoringCase(suffix, "em"))
        return *number * fontSize;
    if (equalsIgnoringCase(suffix, "ex"))
        return *number * fontSize / 2;
    const auto unit = std::ranges::find_if(units(), [&](const UnitInfo& info) {
        return info.inSvg && equalsIgnoringCase(info.suffix, suffix);
    });
    if (unit == units().end())
        return std::nullopt;
    return toUserUnits({*number, unit->unit}, pixel, of);
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

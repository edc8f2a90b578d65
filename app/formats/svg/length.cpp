// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/length.h"

#include "app/base/length.h"
#include "app/formats/svg/scanner.h"

#include <algorithm>
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
    const auto unit = std::ranges::find_if(
        units(), [&](const UnitInfo& info) { return equalsIgnoringCase(info.suffix, suffix); });
    if (unit == units().end())
        return std::nullopt;
    return toUserUnits({*number, unit->unit}, pixel, of);
}

double Lengths::diagonal() const
{
    return std::hypot(viewport.x, viewport.y) / std::numbers::sqrt2;
}

} // namespace app::svg

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/length.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace app {

std::span<const UnitInfo> units()
{
    static constexpr std::array all{
        UnitInfo{Unit::User, "", 0, 2},
        UnitInfo{Unit::Mm, "mm", 1, 2},
        UnitInfo{Unit::Cm, "cm", 10, 3},
        UnitInfo{Unit::Inch, "in", 25.4, 3},
        UnitInfo{Unit::Px, "px", 25.4 / 96, 1},
        UnitInfo{Unit::Pt, "pt", 25.4 / 72, 2},
        UnitInfo{Unit::Pc, "pc", 25.4 / 6, 3},
        UnitInfo{Unit::Percent, "%", 0, 1},
        UnitInfo{Unit::Metre, "m", 1000, 3, false},
        UnitInfo{Unit::Foot, "ft", 304.8, 3, false},
    };
    return all;
}

const UnitInfo& infoOf(Unit unit) { return *std::ranges::find(units(), unit, &UnitInfo::unit); }

std::optional<Length> parseLength(std::string_view text)
{
    constexpr std::string_view blank = " \t\r\n";
    const auto trim = [&](std::string_view s) {
        const auto first = std::min(s.find_first_not_of(blank), s.size());
        return s.substr(first, s.find_last_not_of(blank) + 1 - first);
    };
    text = trim(text);
    if (text.starts_with('+'))
        text.remove_prefix(1);
    Length length;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), length.value);
    if (error != std::errc{} || !std::isfinite(length.value))
        return std::nullopt;
    const auto suffix = trim(text.substr(std::size_t(end - text.data())));
    const auto unit = std::ranges::find(units(), suffix, &UnitInfo::suffix);
    if (unit == units().end())
        return std::nullopt;
    length.unit = unit->unit;
    return length;
}

double toUserUnits(Length length, double millimetresPerUnit, double whole)
{
    switch (length.unit) {
    case Unit::User:
        return length.value;
    case Unit::Percent:
        return length.value / 100 * whole;
    default:
        return length.value * (infoOf(length.unit).millimetres / millimetresPerUnit);
    }
}

} // namespace app

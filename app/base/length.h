// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace app {

/// Units of length. User is the drawing's own unit; the page gives its size in millimetres.
enum class Unit { User, Px, Mm, Cm, Inch, Pt, Pc, Percent, Metre, Foot };

/// One row of the catalogue of units.
struct UnitInfo {
    Unit unit;
    std::string_view suffix; ///< in files and fields; "" for User
    double millimetres;      ///< 0 for User and Percent
    int decimals;            ///< shown in the window
    bool inSvg = true;       ///< whether SVG files know it
};
std::span<const UnitInfo> units();
const UnitInfo& infoOf(Unit unit);

/// A number with its unit, as written in a file or typed by a person.
struct Length {
    double value = 0;
    Unit unit = Unit::User;
    friend bool operator==(const Length&, const Length&) = default;
};

/// Parses "10mm", "-3.5", "2 in" or "50%" in the C locale. Empty for any other text, for NaN and
/// for infinity.
std::optional<Length> parseLength(std::string_view text);

/// Converts to user units. `millimetresPerUnit` is the size of a user unit, `whole` the length that
/// 100 % means. Exact if the length's unit has the size of a user unit.
double toUserUnits(Length length, double millimetresPerUnit, double whole = 0);

} // namespace app

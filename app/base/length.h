// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <string_view>

namespace app {

/// Units of length. User: the drawing's own unit, whose size in millimetres the page gives.
enum class Unit { User, Px, Mm, Cm, Inch, Pt, Pc, Percent };

/// One unit of the catalogue: its suffix in files and fields, its size and its usual decimals.
struct UnitInfo {
    Unit unit;
    std::string_view suffix; ///< "" for User
    double millimetres;      ///< 0 for User and Percent
    int decimals;            ///< shown in the window (look.md section 6)
};
std::span<const UnitInfo> units();
const UnitInfo& infoOf(Unit unit);

/// A number with its unit, as a file or a person wrote it.
struct Length {
    double value = 0;
    Unit unit = Unit::User;
    friend bool operator==(const Length&, const Length&) = default;
};

/// "10mm", "-3.5", "2 in", "50%": the C locale's numbers; nothing for anything else, NaN or
/// infinity.
std::optional<Length> parseLength(std::string_view text);

/// In user units. `millimetresPerUnit` is the drawing's; `whole` is what 100 % means. Exact where
/// the unit is as large as the drawing's.
double toUserUnits(Length length, double millimetresPerUnit, double whole = 0);

} // namespace app

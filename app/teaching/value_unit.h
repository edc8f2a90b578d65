// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"

// The units of the numbers that algorithms report in their steps, by variable name.

namespace app {

enum class ValueUnit : std::uint8_t {
    Bare,        ///< a ratio or a share: the same in every unit
    Length,      ///< a length in the drawing
    Area,        ///< a product of two lengths
    X,           ///< an x coordinate, relative to the origin
    Y,           ///< a y coordinate, relative to the origin
    FixedLength, ///< a length that changes if the origin changes
    FixedArea,   ///< a product of such lengths
    Turned       ///< a coordinate in a rotated plane, not in the drawing
};

/// A variable in a trace, and the unit of its numbers.
struct VariableUnit {
    std::string_view name;
    ValueUnit unit;
};

/// The unit of a number (clipping::ValueKind::Number) of this name in a form's trace: from the
/// algorithm's row (app/teaching/teaching.h), otherwise the usual unit of this name, if any.
std::optional<ValueUnit> unitOfValue(const Variant& variant, std::string_view name);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/variants.h"

// In which unit the numbers are that algorithms tell of their steps, by the names of their
// variables.

namespace app {

enum class ValueUnit : std::uint8_t {
    Bare,        ///< a ratio or a share: the same in every unit
    Length,      ///< of the drawing
    Area,        ///< a product of two lengths
    X,           ///< a place on the x axis, counted from the origin
    Y,           ///< a place on the y axis
    FixedLength, ///< a length that is another one where places are counted from another origin
    FixedArea,   ///< such a product
    Turned       ///< of a plane that the algorithm has turned: no place in the drawing
};

/// A variable that steps tell, and the unit of its numbers.
struct VariableUnit {
    std::string_view name;
    ValueUnit unit;
};

/// The unit of a number (clipping::ValueKind::Number) of this name that a form tells: as the
/// algorithm's row says (app/teaching/teaching.h), else the usual one of this name, if there is
/// one.
std::optional<ValueUnit> unitOfValue(const Variant& variant, std::string_view name);

} // namespace app

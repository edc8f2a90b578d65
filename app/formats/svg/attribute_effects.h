// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

// Every attribute of SVG that is no property of style (property.h): whether it is read, lost, or
// without effect. One that is in no table is told as unknown.

namespace app::svg {

struct AttributeEffect {
    enum class Kind : std::uint8_t {
        Read,   ///< by the reader of an element, wherever it has an effect
        Lost,   ///< it may change the picture, and is not evaluated
        None,   ///< it changes no pixel of a drawing
        Unknown ///< SVG does not have it
    };
    std::string_view name; ///< with * at its end: all with this beginning
    Kind kind = Kind::Unknown;
    std::string_view without{}; ///< Lost: the values, separated by blanks, that change nothing
};
std::span<const AttributeEffect> attributeEffects();

/// How an attribute is treated that is no property. Names with a prefix belong to other
/// vocabularies.
AttributeEffect effectOf(std::string_view attribute);

} // namespace app::svg

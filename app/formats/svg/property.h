// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/style.h"

#include <span>

// Tables of the properties of SVG and CSS that are evaluated, kept, or of no effect here. A
// property that is in none of them is reported as lost.

namespace app::svg {

/// A value that is set, and where.
struct Given {
    std::string_view property;
    const Lengths& lengths;
    bool isCss = false; ///< in CSS, not an attribute
};

/// A property that is evaluated.
struct Property {
    /// Whether an attribute of this name means the same, or, Shape, is read with the shape.
    enum class Attribute : std::uint8_t { Same, Other, Shape };

    std::string_view name;
    /// False if the value is not understood; then nothing changes.
    bool (*set)(Properties& properties, std::string_view value, const Given& given);
    void (*copy)(Properties& to, const Properties& from); ///< null: cannot be inherited
    bool inherited = false;
    Attribute attribute = Attribute::Same;
};
std::span<const Property> properties();
std::span<const Property> textProperties();          ///< those of them that change letters alone
const Property* findProperty(std::string_view name); ///< null: it is not evaluated

/// A property that changes the picture, but is not evaluated.
struct LostProperty {
    std::string_view name;    ///< with * at its end: all with this beginning
    std::string_view without; ///< the values, separated by blanks, with which it changes nothing
    bool ofRoot = false;      ///< whether it has an effect on the root alone
};
std::span<const LostProperty> lostProperties();

/// Properties that do not change how shapes look, with * as above.
std::span<const std::string_view> propertiesWithoutEffect();

bool hasNoEffect(std::string_view name);

/// Whether a property that is not evaluated and has an effect changes the picture with this value,
/// as far as is known.
bool isLost(std::string_view name, std::string_view value, bool isRoot);

/// The name of a property in small letters, and without the prefix of a browser that is only
/// another name for it.
std::string plainName(std::string_view name);

} // namespace app::svg

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style.h"
#include "app/formats/svg/css.h"
#include "app/formats/svg/length.h"

namespace app::svg {

/// The value of a fill or stroke before references are resolved.
struct Paint {
    enum class Kind : std::uint8_t { None, Solid, Current, Reference };
    Kind kind = Kind::None;
    Colour colour{}; ///< Solid: the colour; Reference: the fallback if the reference is not found
    bool hasFallback = false;
    std::string_view reference{}; ///< "url(#gradient)"
};

/// The properties of an element that Clearcut evaluates. The strings are views into the tree or the
/// style sheet.
struct Properties {
    // inherited from the parent
    Paint fill{Paint::Kind::Solid}, stroke{};
    Colour colour{}; ///< the value of currentColor
    double fillOpacity = 1, strokeOpacity = 1;
    double width = 1, miterLimit = 4, dashOffset = 0;
    std::vector<double> dashes{};
    Cap cap = Cap::Butt;
    Join join = Join::Miter;
    FillRule fillRule = FillRule::NonZero, clipRule = FillRule::NonZero;
    bool visible = true;
    double fontSize = 16;
    std::string_view markerStart{}, markerMid{}, markerEnd{};

    // the element's own
    double opacity = 1;
    bool displayed = true;
    bool overflowShown = false; ///< whether content outside the element's viewport is visible
    bool fixedWidth = false;    ///< vector-effect: non-scaling-stroke
    std::string_view transform{}, clipPath{}, mask{}, filter{}, blending{};
    Paint stopColour{Paint::Kind::Solid};
    double stopOpacity = 1;

    bool longDashes = false; ///< whether a pattern longer than mostDashes was dropped

    /// The initial properties of the element's children.
    Properties inherited() const;
};

/// Computes the properties of elements. In order of increasing priority: presentation attributes,
/// rules of the style sheet, style="", declarations marked !important.
class Styles {
public:
    explicit Styles(const Tree& tree);

    Properties of(Node node, const Properties& parent, const Lengths& lengths);
    int ignoredRules() const { return sheet_.ignored(); }

private:
    using Setter = void (*)(Properties&, std::string_view value, const Lengths&);
    struct Property;
    static const Property* find(std::string_view name);
    static void set(const Property& property, Properties& properties, std::string_view value,
                    const Properties& parent, const Lengths& lengths);

    std::string_view uncommented(const Tree::Attribute& attribute);

    const Tree& tree_;
    StyleSheet sheet_;
    std::unordered_map<std::uint32_t, std::string> uncommented_; ///< by the offset of their values
    std::vector<const Property*> byName_;                        ///< by attribute name of tree_
};

} // namespace app::svg

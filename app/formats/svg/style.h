// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style.h"
#include "app/formats/svg/css.h"
#include "app/formats/svg/length.h"

namespace app::svg {

/// What a fill or stroke says, before references are followed.
struct Paint {
    enum class Kind : std::uint8_t { None, Solid, Current, Reference };
    Kind kind = Kind::None;
    Colour colour{}; ///< Solid: itself; Reference: what to take if there is no such thing
    bool hasFallback = false;
    std::string_view reference{}; ///< "url(#gradient)"
};

/// The properties of an element, as far as Clearcut looks at them. The strings are views into the
/// tree or the style sheet.
struct Properties {
    // inherited
    Paint fill{Paint::Kind::Solid}, stroke{};
    Colour colour{}; ///< what currentColor means
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
    bool overflowShown = false; ///< what is outside of the element's viewport
    bool fixedWidth = false;    ///< vector-effect: non-scaling-stroke
    std::string_view transform{}, clipPath{}, mask{}, filter{}, blending{};
    Paint stopColour{Paint::Kind::Solid};
    double stopOpacity = 1;

    bool longDashes = false; ///< a pattern longer than mostDashes was left out

    /// What children begin with.
    Properties inherited() const;
};

/// Computes properties: presentation attributes, then the style sheet's rules, then style="", then
/// what is !important.
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
    std::unordered_map<std::uint32_t, std::string> uncommented_; ///< values by their offset
    std::vector<const Property*> byName_;                        ///< of the tree's attribute names
};

} // namespace app::svg

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/style_table.h"
#include "app/formats/svg/attribute_effects.h"
#include "app/formats/svg/css.h"
#include "app/formats/svg/length.h"
#include "app/formats/svg/text_style.h"
#include "app/formats/svg/variables.h"

#include <array>
#include <unordered_set>

namespace app::svg {

/// The value of a fill or stroke before references are resolved.
struct Paint {
    enum class Kind : std::uint8_t {
        None,
        Solid,
        Current,
        Reference,
        ContextFill, ///< that of the element with the marker, or of the <use>
        ContextStroke
    };
    Kind kind = Kind::None;
    Colour colour{};
    Kind fallback = Kind::None;   ///< of a reference that is not found; Solid: `colour`
    std::string_view reference{}; ///< "url(#gradient)"
};

/// The order in which fill, stroke and markers of a shape are painted.
enum class PaintPart : std::uint8_t { Fill, Stroke, Markers };
using PaintOrder = std::array<PaintPart, 3>;

/// How an element is transformed, as written. An empty text says nothing.
struct TransformTexts {
    struct Written {
        std::string_view text{};
        bool isCss = false; ///< in CSS, lengths and angles need units
    };
    Written functions{};                    ///< "rotate(30)": the attribute or property transform
    Written translate{}, rotate{}, scale{}; ///< properties of CSS, applied before the functions
    Written origin{}, box{};
};

/// A length of a shape that a style sets, instead of the attribute of this name.
struct ShapeValue {
    std::string_view name, value;
};

/// The properties of an element that Clearcut evaluates. The strings are views into the tree, the
/// style sheet or texts of `Styles`.
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
    bool linearColours = false; ///< color-interpolation, which matters in masks
    PaintOrder paintOrder{PaintPart::Fill, PaintPart::Stroke, PaintPart::Markers};
    double fontSize = 16;
    TextStyle text{};
    std::string_view markerStart{}, markerMid{}, markerEnd{};
    Paint contextFill{}, contextStroke{}; ///< what context-fill and context-stroke mean
    std::shared_ptr<const Variables> variables{};

    // the element's own
    double opacity = 1;
    bool displayed = true;
    bool overflowShown = false; ///< whether content outside the element's viewport is visible
    bool overflowGiven = false; ///< whether a style says so; viewports are usually hidden outside
    bool fixedWidth = false;    ///< vector-effect: non-scaling-stroke
    bool sharpPixels = false;   ///< of images, which are smoothed here
    bool maskByAlpha = false;   ///< of a mask: whether its colours do not count
    TransformTexts transform{};
    std::string_view clipPath{}, mask{}, filter{}, blending{};
    Paint stopColour{Paint::Kind::Solid};
    double stopOpacity = 1;
    std::vector<ShapeValue> shape{};
    std::string_view alignment{}; ///< of a part of a text: the line that lies on that of the rest
    double baselineShift = 0;     ///< of a part of a text, upwards
    enum class Script : std::uint8_t { None, Above, Below };
    Script script = Script::None; ///< whether it is as high as the font says

    bool longDashes = false; ///< whether a pattern longer than mostDashes was dropped

    /// The initial properties of the element's children.
    Properties inherited() const;
};

/// The text of a length such as "width": the CSS property of this name, or else the attribute.
std::string_view lengthText(const Tree& tree, Node node, const Properties& properties,
                            std::string_view name);

struct Property;
class Report;

/// Computes the properties of elements. In order of increasing priority: presentation attributes,
/// rules of the style sheet, style="", declarations marked !important. Reports every property and
/// value that changes the picture and is not evaluated.
class Styles {
public:
    Styles(const Tree& tree, Report& report);

    Properties of(Node node, const Properties& parent, const Lengths& lengths);

    /// Counts on from the work of others, for the limits of all together.
    void takeWork(Styles& of)
    {
        sheet_.tried() = of.sheet_.tried();
        variableWork_ = of.variableWork_;
    }

private:
    struct Cascade;
    /// How an attribute is treated, by its name.
    struct Attribute {
        const Property* property; ///< null: none
        AttributeEffect effect;   ///< without property
        bool isTold;              ///< whether a use may be reported
        bool isStyle;
    };

    std::string_view styleAttribute(Node node);
    bool setsFont(const Cascade& cascade) const;
    void applyAll(Cascade& cascade);
    void applyVariables(Cascade& cascade);
    void applyAttributes(Cascade& cascade);
    void apply(Cascade& cascade, const Declaration& declaration);
    void tell(const AttributeEffect& effect, std::string_view name, std::string_view value);
    void set(Cascade& cascade, const Property& property, std::string_view value, bool isCss);

    /// How a declaration of CSS is treated, by its name.
    struct Meaning {
        const Property* property = nullptr; ///< null: it is not evaluated
        std::string lost{};                 ///< its plain name, if it may change the picture
    };
    const Meaning& meaningOf(std::string_view name);
    std::string_view uncommented(const Tree::Attribute& attribute);
    std::string_view withVariables(std::string_view value, const Cascade& cascade);

    const Tree& tree_;
    Report& report_;
    StyleSheet sheet_;
    std::unordered_map<std::uint32_t, std::string> uncommented_; ///< by the offset of their values
    std::unordered_set<std::string> texts_; ///< values whose variables were replaced
    std::size_t variableWork_ = 0;          ///< for these
    std::vector<Attribute> attributes_;     ///< by name in tree_
    std::unordered_map<std::string_view, Meaning> meanings_;
};

} // namespace app::svg

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/attribute_effects.h"

#include "app/formats/svg/property.h"

#include <algorithm>
#include <array>
#include <vector>

namespace app::svg {
namespace {

using NameList = std::string_view; // separated by blanks

constexpr NameList readAttributes =
    // of all elements
    "class href id requiredExtensions style systemLanguage xlink:href xml:space "
    // of shapes and viewports
    "pathLength points preserveAspectRatio viewBox x1 x2 y1 y2 "
    // of texts
    "dx dy lengthAdjust path rotate side startOffset textLength "
    // of clip paths, masks and markers
    "clipPathUnits markerHeight markerUnits markerWidth maskContentUnits maskUnits orient refX "
    "refY "
    // of gradients and patterns
    "fr fx fy gradientTransform gradientUnits offset patternContentUnits "
    "patternUnits spreadMethod "
    // of style sheets
    "media type";

struct HarmlessAttributes {
    std::string_view why;
    NameList names;
};
constexpr std::array harmlessAttributes{
    HarmlessAttributes{
        "it describes the file or its parts for people and programs",
        "aria-* baseProfile contentScriptType contentStyleType data-* focusHighlight "
        "fetchpriority externalResourcesRequired is itemid itemprop itemref itemscope "
        "itemtype lang name nonce part role slot title translate typeof about property "
        "resource rel rev content datatype vocab prefix version xml:id xml:lang"},
    HarmlessAttributes{
        "it says what happens when a person does something",
        "autofocus contenteditable cursor download draggable editable focusable hreflang "
        "nav-* ping referrerpolicy snapshotTime spellcheck tabindex target viewTarget "
        "zoomAndPan on*"},
    HarmlessAttributes{"it only says how a file is loaded",
                       "crossorigin decoding loading playbackorder progressive requiredFeatures "
                       "requiredFonts requiredFormats timelinebegin transferBehavior"},
    HarmlessAttributes{"some programs write it without the prefix that gives it a meaning",
                       "space"},
    HarmlessAttributes{"no program draws it in another way", "method spacing"},
    HarmlessAttributes{"the mean colour of a pattern does not depend on it", "patternTransform"},
    HarmlessAttributes{
        "it is of animations, which are told themselves",
        "accumulate additive attributeName attributeType begin by calcMode dur end fill "
        "from keyPoints keySplines keyTimes max min origin repeatCount repeatDur restart "
        "syncBehavior syncMaster syncTolerance to values"},
    HarmlessAttributes{
        "it is of filters, which are told themselves",
        "amplitude azimuth baseFrequency bias diffuseConstant divisor edgeMode elevation exponent "
        "filterRes filterUnits in in2 intercept k1 k2 k3 k4 kernelMatrix kernelUnitLength "
        "limitingConeAngle mode numOctaves operator order pointsAtX pointsAtY pointsAtZ "
        "preserveAlpha primitiveUnits radius result scale seed slope specularConstant "
        "specularExponent "
        "stdDeviation stitchTiles surfaceScale tableValues targetX targetY xChannelSelector "
        "yChannelSelector z"},
    HarmlessAttributes{
        "it is of fonts in the file, which are told where texts use them",
        "accent-height alphabetic arabic-form ascent bbox cap-height descent format g1 g2 "
        "glyph-name glyphRef hanging horiz-adv-x horiz-origin-x horiz-origin-y ideographic k "
        "mathematical orientation overline-position overline-thickness panose-1 stemh stemv "
        "strikethrough-position strikethrough-thickness string u1 u2 underline-position "
        "underline-thickness unicode unicode-range units-per-em v-alphabetic v-hanging "
        "v-ideographic v-mathematical vert-adv-y vert-origin-x vert-origin-y widths x-height"},
    HarmlessAttributes{"it is of colour profiles, of which the usual colours are read",
                       "local rendering-intent"},
};

constexpr std::array lostAttributes{
    AttributeEffect{"clip", AttributeEffect::Kind::Lost, "auto"},
    AttributeEffect{"onload", AttributeEffect::Kind::Lost},
    AttributeEffect{"shape-rendering", AttributeEffect::Kind::Lost, "auto geometricPrecision"},
    AttributeEffect{"xml:base", AttributeEffect::Kind::Lost},
};

std::vector<AttributeEffect> makeEffects()
{
    std::vector<AttributeEffect> all(lostAttributes.begin(), lostAttributes.end());
    const auto add = [&](NameList names, AttributeEffect::Kind kind) {
        for (std::size_t from = 0; from < names.size();) {
            const auto end = std::min(names.find(' ', from), names.size());
            all.push_back({names.substr(from, end - from), kind});
            from = end + 1;
        }
    };
    add(readAttributes, AttributeEffect::Kind::Read);
    for (const HarmlessAttributes& each : harmlessAttributes)
        add(each.names, AttributeEffect::Kind::None);
    return all;
}

bool isNamed(std::string_view name, std::string_view pattern)
{
    return pattern.ends_with('*') ? name.starts_with(pattern.substr(0, pattern.size() - 1))
                                  : name == pattern;
}

} // namespace

std::span<const AttributeEffect> attributeEffects()
{
    static const auto all = makeEffects();
    return all;
}

AttributeEffect effectOf(std::string_view attribute)
{
    using Kind = AttributeEffect::Kind;
    const auto all = attributeEffects();
    const auto found = std::ranges::find_if(
        all, [&](const AttributeEffect& each) { return isNamed(attribute, each.name); });
    if (found != all.end())
        return *found;
    if (attribute.find(':') != attribute.npos || attribute.front() == '#')
        return {attribute, Kind::None}; // of Inkscape and others; "#text" is the reader's own
    return {attribute, hasNoEffect(attribute) ? Kind::None : Kind::Unknown};
}

} // namespace app::svg

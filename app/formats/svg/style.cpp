// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/style.h"

#include "app/formats/svg/colour.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/scanner.h"

#include <algorithm>
#include <array>

namespace app::svg {

// A row of the table of properties. An invalid value changes nothing.
struct Styles::Property {
    std::string_view name;
    Setter set;
    void (*inherit)(Properties& to, const Properties& from);
};

namespace {

using P = Properties;
using Value = std::string_view;

template <auto member>
void inherit(P& to, const P& from)
{
    to.*member = from.*member;
}

std::optional<Paint> parsePaint(Value text)
{
    if (text == "none" || text == "context-fill" || text == "context-stroke")
        return Paint{};
    if (equalsIgnoringCase(text, "currentcolor"))
        return Paint{Paint::Kind::Current};
    if (text.starts_with("url(")) {
        const auto end = std::min(text.find(')'), text.size() - 1) + 1;
        const auto fallback = parseColour(text.substr(end));
        return Paint{Paint::Kind::Reference, fallback.value_or(Colour{}), fallback.has_value(),
                     text.substr(0, end)};
    }
    const auto colour = parseColour(text.substr(0, text.find(" icc-color")));
    return colour ? std::optional(Paint{Paint::Kind::Solid, *colour}) : std::nullopt;
}

template <auto member>
void setPaint(P& p, Value text, const Lengths&)
{
    if (const auto paint = parsePaint(text))
        p.*member = *paint;
}

template <auto member>
void setOpacity(P& p, Value text, const Lengths&)
{
    if (const auto opacity = parseOpacity(text))
        p.*member = *opacity;
}

template <auto member>
void setText(P& p, Value text, const Lengths&)
{
    p.*member = text == "none" ? Value() : text;
}

template <auto member>
void setRule(P& p, Value text, const Lengths&)
{
    if (text == "evenodd" || text == "nonzero")
        p.*member = text == "evenodd" ? FillRule::EvenOdd : FillRule::NonZero;
}

void setColour(P& p, Value text, const Lengths&)
{
    if (const auto colour = parseColour(text))
        p.colour = *colour;
}

void setWidth(P& p, Value text, const Lengths& lengths)
{
    if (const auto width = lengths.other(text); width && *width >= 0)
        p.width = *width;
}

void setMiterLimit(P& p, Value text, const Lengths& lengths)
{
    if (const auto limit = lengths.parse(text, 1); limit && *limit >= 1)
        p.miterLimit = *limit;
}

void setDashOffset(P& p, Value text, const Lengths& lengths)
{
    if (const auto offset = lengths.other(text))
        p.dashOffset = *offset;
}

void setDashes(P& p, Value text, const Lengths& lengths)
{
    p.longDashes = false;
    std::vector<double> dashes;
    double sum = 0;
    for (text = trimmed(text); !text.empty() && text != "none"; text = trimmed(text)) {
        const auto end = std::min(text.find_first_of(" \t\r\n,"), text.size());
        const auto dash = lengths.other(text.substr(0, end));
        if (!dash || *dash < 0)
            return;
        dashes.push_back(*dash);
        sum += *dash;
        text = trimmed(text.substr(end));
        text.remove_prefix(text.starts_with(','));
        if (dashes.size() > mostDashes) {
            p.longDashes = true;
            break;
        }
    }
    p.dashes = sum > 0 && !p.longDashes ? std::move(dashes) : std::vector<double>();
}

void setCap(P& p, Value text, const Lengths&)
{
    p.cap = text == "round" ? Cap::Round : text == "square" ? Cap::Square : Cap::Butt;
}

void setJoin(P& p, Value text, const Lengths&)
{
    p.join = text == "round" ? Join::Round : text == "bevel" ? Join::Bevel : Join::Miter;
}

void setFontSize(P& p, Value text, const Lengths& lengths)
{
    if (const auto size = lengths.parse(text, lengths.fontSize); size && *size > 0)
        p.fontSize = *size;
}

void setDisplay(P& p, Value text, const Lengths&) { p.displayed = text != "none"; }
void setVisibility(P& p, Value text, const Lengths&) { p.visible = text == "visible"; }
void setOverflow(P& p, Value text, const Lengths&)
{
    p.overflowShown = text == "visible" || text == "auto";
}

void setVectorEffect(P& p, Value text, const Lengths&)
{
    p.fixedWidth = text == "non-scaling-stroke";
}

void setBlending(P& p, Value text, const Lengths&)
{
    p.blending = text == "normal" ? Value() : text;
}

void setMarkers(P& p, Value text, const Lengths& lengths)
{
    setText<&P::markerStart>(p, text, lengths);
    setText<&P::markerMid>(p, text, lengths);
    setText<&P::markerEnd>(p, text, lengths);
}

void inheritMarkers(P& to, const P& from)
{
    to.markerStart = from.markerStart;
    to.markerMid = from.markerMid;
    to.markerEnd = from.markerEnd;
}

} // namespace

const Styles::Property* Styles::find(std::string_view name)
{
    static constexpr std::array all{
        Property{"color", setColour, inherit<&P::colour>},
        Property{"fill", setPaint<&P::fill>, inherit<&P::fill>},
        Property{"stroke", setPaint<&P::stroke>, inherit<&P::stroke>},
        Property{"fill-opacity", setOpacity<&P::fillOpacity>, inherit<&P::fillOpacity>},
        Property{"stroke-opacity", setOpacity<&P::strokeOpacity>, inherit<&P::strokeOpacity>},
        Property{"opacity", setOpacity<&P::opacity>, inherit<&P::opacity>},
        Property{"stroke-width", setWidth, inherit<&P::width>},
        Property{"stroke-miterlimit", setMiterLimit, inherit<&P::miterLimit>},
        Property{"stroke-dashoffset", setDashOffset, inherit<&P::dashOffset>},
        Property{"stroke-dasharray", setDashes, inherit<&P::dashes>},
        Property{"stroke-linecap", setCap, inherit<&P::cap>},
        Property{"stroke-linejoin", setJoin, inherit<&P::join>},
        Property{"fill-rule", setRule<&P::fillRule>, inherit<&P::fillRule>},
        Property{"clip-rule", setRule<&P::clipRule>, inherit<&P::clipRule>},
        Property{"visibility", setVisibility, inherit<&P::visible>},
        Property{"display", setDisplay, inherit<&P::displayed>},
        Property{"font-size", setFontSize, inherit<&P::fontSize>},
        Property{"overflow", setOverflow, inherit<&P::overflowShown>},
        Property{"vector-effect", setVectorEffect, inherit<&P::fixedWidth>},
        Property{"transform", setText<&P::transform>, inherit<&P::transform>},
        Property{"clip-path", setText<&P::clipPath>, inherit<&P::clipPath>},
        Property{"mask", setText<&P::mask>, inherit<&P::mask>},
        Property{"filter", setText<&P::filter>, inherit<&P::filter>},
        Property{"mix-blend-mode", setBlending, inherit<&P::blending>},
        Property{"marker", setMarkers, inheritMarkers},
        Property{"marker-start", setText<&P::markerStart>, inherit<&P::markerStart>},
        Property{"marker-mid", setText<&P::markerMid>, inherit<&P::markerMid>},
        Property{"marker-end", setText<&P::markerEnd>, inherit<&P::markerEnd>},
        Property{"stop-color", setPaint<&P::stopColour>, inherit<&P::stopColour>},
        Property{"stop-opacity", setOpacity<&P::stopOpacity>, inherit<&P::stopOpacity>},
    };
    static const auto index = [] {
        std::unordered_map<std::string_view, const Property*> map;
        for (const Property& property : all)
            map.emplace(property.name, &property);
        return map;
    }();
    const auto found = index.find(name);
    return found == index.end() ? nullptr : found->second;
}

Properties Properties::inherited() const
{
    Properties child = *this;
    const Properties initial;
    child.opacity = initial.opacity;
    child.displayed = initial.displayed;
    child.overflowShown = initial.overflowShown;
    child.fixedWidth = initial.fixedWidth;
    child.transform = child.clipPath = child.mask = child.filter = child.blending = {};
    child.stopColour = initial.stopColour;
    child.stopOpacity = initial.stopOpacity;
    return child;
}

Styles::Styles(const Tree& tree) : tree_(tree), sheet_(tree.styleSheet())
{
    for (std::uint32_t name = 0; name < tree.nameCount(); ++name)
        byName_.push_back(find(tree.nameOf(name)));
}

void Styles::set(const Property& property, Properties& properties, std::string_view value,
                 const Properties& parent, const Lengths& lengths)
{
    value = trimmed(value);
    if (value == "inherit")
        property.inherit(properties, parent);
    else
        property.set(properties, value, lengths);
}

std::string_view Styles::uncommented(const Tree::Attribute& attribute)
{
    const auto value = tree_.valueOf(attribute);
    if (value.find("/*") == value.npos)
        return value;
    const auto [known, isNew] = uncommented_.try_emplace(attribute.offset);
    if (isNew)
        known->second = withoutComments(value, 1);
    return known->second;
}

Properties Styles::of(Node node, const Properties& parent, const Lengths& around)
{
    Properties result = parent.inherited();
    Lengths lengths = around;
    lengths.fontSize = parent.fontSize;
    std::string_view inlined;
    for (auto attribute = tree_.begin(node); attribute != tree_.last(node); ++attribute) {
        if (const Property* property = byName_[attribute->name])
            set(*property, result, uncommented(*attribute), parent, lengths);
        else if (tree_.nameOf(attribute->name) == "style")
            inlined = uncommented(*attribute);
    }
    if (inlined.empty() && sheet_.empty())
        return result;
    const auto rules =
        sheet_.empty() ? decltype(sheet_.matching(tree_, node)){} : sheet_.matching(tree_, node);
    const auto own = parseDeclarations(inlined);
    for (const bool important : {false, true}) {
        const auto apply = [&](const std::vector<Declaration>& declarations) {
            for (const Declaration& declaration : declarations)
                if (declaration.important == important)
                    if (const Property* property = find(declaration.property))
                        set(*property, result, declaration.value, parent, lengths);
        };
        for (const auto* rule : rules)
            apply(*rule);
        apply(own);
    }
    return result;
}

} // namespace app::svg

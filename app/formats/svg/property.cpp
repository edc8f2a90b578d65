// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/property.h"

#include "app/formats/svg/calc.h"
#include "app/formats/svg/colour.h"
#include "app/formats/svg/element_transform.h"
#include "app/formats/svg/limits.h"
#include "app/formats/svg/scanner.h"

#include <algorithm>
#include <array>
#include <unordered_map>

namespace app::svg {
namespace {

using P = Properties;
using Value = std::string_view;

bool is(Value value, Value word) { return equalsIgnoringCase(value, word); }

template <auto member>
void copy(P& to, const P& from)
{
    to.*member = from.*member;
}

// The keyword's position in the list, or nothing.
template <std::size_t size>
std::optional<std::size_t> wordOf(Value value, const std::array<Value, size>& words)
{
    const auto found = std::ranges::find_if(words, [&](Value word) { return is(value, word); });
    return found == words.end() ? std::nullopt : std::optional(std::size_t(found - words.begin()));
}

Paint withFallback(Value text)
{
    const auto end = std::min(text.find(')'), text.size() - 1) + 1;
    const Value after = trimmed(text.substr(end));
    Paint paint{Paint::Kind::Reference};
    paint.reference = text.substr(0, end);
    if (is(after, "currentcolor"))
        paint.fallback = Paint::Kind::Current;
    else if (const auto colour = parseColour(after)) {
        paint.fallback = Paint::Kind::Solid;
        paint.colour = *colour;
    }
    return paint;
}

std::optional<Paint> parsePaint(Value text)
{
    if (is(text, "none"))
        return Paint{};
    if (is(text, "context-fill"))
        return Paint{Paint::Kind::ContextFill};
    if (is(text, "context-stroke"))
        return Paint{Paint::Kind::ContextStroke};
    if (is(text, "currentcolor"))
        return Paint{Paint::Kind::Current};
    if (is(text.substr(0, 4), "url("))
        return withFallback(text);
    const auto colour = parseColour(text.substr(0, text.find(" icc-color")));
    return colour ? std::optional(Paint{Paint::Kind::Solid, *colour}) : std::nullopt;
}

template <auto member>
bool setPaint(P& p, Value text, const Given&)
{
    const auto paint = parsePaint(text);
    if (paint)
        p.*member = *paint;
    return paint.has_value();
}

template <auto member>
bool setOpacity(P& p, Value text, const Given&)
{
    const auto opacity = parseOpacity(text);
    if (opacity)
        p.*member = *opacity;
    return opacity.has_value();
}

template <auto member>
bool setText(P& p, Value text, const Given&)
{
    p.*member = is(text, "none") ? Value() : text;
    return true;
}

template <auto member>
bool setRule(P& p, Value text, const Given&)
{
    const auto rule = wordOf(text, std::array<Value, 2>{"nonzero", "evenodd"});
    if (rule)
        p.*member = *rule == 0 ? FillRule::NonZero : FillRule::EvenOdd;
    return rule.has_value();
}

bool setColour(P& p, Value text, const Given&)
{
    const auto colour = parseColour(text);
    if (colour)
        p.colour = *colour;
    return colour || is(text, "currentcolor"); // which is the colour of the parent
}

bool setWidth(P& p, Value text, const Given& given)
{
    const auto width = given.lengths.other(text);
    if (!width || *width < 0)
        return false;
    p.width = *width;
    return true;
}

bool setMiterLimit(P& p, Value text, const Given& given)
{
    const bool isNumber = isCalc(text) || text.find_first_not_of("0123456789.eE+-") == text.npos;
    const auto limit = isNumber ? given.lengths.parse(text, 1) : std::nullopt;
    if (!limit || *limit < 1)
        return false;
    p.miterLimit = *limit;
    return true;
}

bool setDashOffset(P& p, Value text, const Given& given)
{
    const auto offset = given.lengths.other(text);
    if (offset)
        p.dashOffset = *offset;
    return offset.has_value();
}

bool setDashes(P& p, Value text, const Given& given)
{
    std::vector<double> dashes;
    double sum = 0;
    constexpr Value separators = " \t\r\n\f,";
    text = is(text, "none") ? Value() : text;
    for (auto word = takeWord(text, separators); !word.empty() && dashes.size() <= mostDashes;
         word = takeWord(text, separators)) {
        const auto dash = given.lengths.other(word);
        if (!dash || *dash < 0)
            return false;
        dashes.push_back(*dash);
        sum += *dash;
    }
    p.longDashes = dashes.size() > mostDashes;
    p.dashes = sum > 0 && !p.longDashes ? std::move(dashes) : std::vector<double>();
    return true;
}

bool setCap(P& p, Value text, const Given&)
{
    const auto cap = wordOf(text, std::array<Value, 3>{"butt", "round", "square"});
    if (cap)
        p.cap = std::array{Cap::Butt, Cap::Round, Cap::Square}[*cap];
    return cap.has_value();
}

bool setJoin(P& p, Value text, const Given&)
{
    const auto join = wordOf(text, std::array<Value, 3>{"miter", "round", "bevel"});
    if (join)
        p.join = std::array{Join::Miter, Join::Round, Join::Bevel}[*join];
    return join.has_value();
}

bool setDisplay(P& p, Value text, const Given&)
{
    p.displayed = !is(text, "none");
    return true;
}

bool setVisibility(P& p, Value text, const Given&)
{
    const auto word = wordOf(text, std::array<Value, 3>{"visible", "hidden", "collapse"});
    if (word)
        p.visible = *word == 0;
    return word.has_value();
}

bool setOverflow(P& p, Value text, const Given&)
{
    p.overflowShown = is(text, "visible") || is(text, "auto");
    p.overflowGiven = true;
    return true;
}

// Where no style says it, the value that is inherited is "visible".
void copyOverflow(P& to, const P& from)
{
    to.overflowShown = from.overflowShown || !from.overflowGiven;
    to.overflowGiven = true;
}

bool setImageRendering(P& p, Value text, const Given&)
{
    const auto way =
        wordOf(text, std::array<Value, 7>{"auto", "smooth", "high-quality", "optimizequality",
                                          "pixelated", "crisp-edges", "optimizespeed"});
    if (way)
        p.sharpPixels = *way >= 4;
    return way.has_value();
}

bool setMaskType(P& p, Value text, const Given&)
{
    const auto type = wordOf(text, std::array<Value, 2>{"luminance", "alpha"});
    if (type)
        p.maskByAlpha = *type == 1;
    return type.has_value();
}

bool setInterpolation(P& p, Value text, const Given&)
{
    const auto space = wordOf(text, std::array<Value, 3>{"auto", "srgb", "linearrgb"});
    if (space)
        p.linearColours = *space == 2;
    return space.has_value();
}

bool setVectorEffect(P& p, Value text, const Given&)
{
    const auto effect = wordOf(text, std::array<Value, 2>{"none", "non-scaling-stroke"});
    if (effect)
        p.fixedWidth = *effect == 1;
    return effect.has_value();
}

bool setBlending(P& p, Value text, const Given&)
{
    p.blending = is(text, "normal") ? Value() : text;
    return true;
}

// "fill stroke markers" in any order; what is left out follows in this order.
bool setPaintOrder(P& p, Value text, const Given&)
{
    std::vector<PaintPart> order;
    const auto isIn = [&](PaintPart part) { return std::ranges::count(order, part) > 0; };
    const auto words = is(text, "normal") ? std::vector<Value>() : wordsOf(text);
    for (const Value word : words) {
        const auto part = wordOf(word, std::array<Value, 3>{"fill", "stroke", "markers"});
        if (!part || isIn(PaintPart(*part)))
            return false;
        order.push_back(PaintPart(*part));
    }
    for (const PaintPart part : PaintOrder{PaintPart::Fill, PaintPart::Stroke, PaintPart::Markers})
        if (!isIn(part))
            order.push_back(part);
    std::ranges::copy(order, p.paintOrder.begin());
    return true;
}

bool setMarkers(P& p, Value text, const Given& given)
{
    return setText<&P::markerStart>(p, text, given) && setText<&P::markerMid>(p, text, given)
           && setText<&P::markerEnd>(p, text, given);
}

void copyMarkers(P& to, const P& from)
{
    to.markerStart = from.markerStart;
    to.markerMid = from.markerMid;
    to.markerEnd = from.markerEnd;
}

template <auto part>
bool setTransform(P& p, Value text, const Given& given)
{
    TransformTexts only;
    only.*part = {text, given.isCss};
    const bool understood = matrixOf(only, given.lengths, {}).has_value();
    if (understood)
        p.transform.*part = only.*part;
    return understood;
}

template <auto part>
void copyTransform(P& to, const P& from)
{
    to.transform.*part = from.transform.*part;
}

// The outline of a path as a string: path("M0 0L9 9").
std::optional<Value> pathString(Value text)
{
    if (!is(text.substr(0, 5), "path(") || !text.ends_with(')'))
        return std::nullopt;
    text = trimmed(text.substr(5, text.size() - 6));
    const bool quoted = text.size() >= 2 && (text.front() == '"' || text.front() == '\'')
                        && text.back() == text.front();
    return quoted ? std::optional(text.substr(1, text.size() - 2)) : std::nullopt;
}

bool setOutline(P& p, Value text, const Given& given)
{
    const auto path = is(text, "none") ? std::optional(Value("none")) : pathString(text);
    if (path)
        p.shape.push_back({given.property, *path});
    return path.has_value();
}

template <bool negative>
bool setPosition(P& p, Value text, const Given& given)
{
    const auto length = given.lengths.parse(text, 1);
    if (!length || (*length < 0 && !negative) || (given.isCss && lacksUnit(text)))
        return false;
    p.shape.push_back({given.property, text});
    return true;
}

// A size, which may be auto.
bool setSize(P& p, Value text, const Given& given)
{
    if (!is(text, "auto"))
        return setPosition<false>(p, text, given);
    p.shape.push_back({given.property, "auto"});
    return true;
}

template <auto member>
constexpr Property inherited(Value name, decltype(Property::set) set)
{
    return {name, set, copy<member>, true};
}

template <auto member>
constexpr Property own(Value name, decltype(Property::set) set)
{
    return {name, set, copy<member>};
}

template <auto part>
constexpr Property transforms(Value name, Property::Attribute attribute)
{
    return {name, setTransform<part>, copyTransform<part>, false, attribute};
}

constexpr Property shape(Value name, decltype(Property::set) set)
{
    return {name, set, nullptr, false, Property::Attribute::Shape};
}

constexpr auto same = Property::Attribute::Same, other = Property::Attribute::Other;
using T = TransformTexts;

constexpr std::array allProperties{
    inherited<&P::colour>("color", setColour),
    inherited<&P::fill>("fill", setPaint<&P::fill>),
    inherited<&P::stroke>("stroke", setPaint<&P::stroke>),
    inherited<&P::fillOpacity>("fill-opacity", setOpacity<&P::fillOpacity>),
    inherited<&P::strokeOpacity>("stroke-opacity", setOpacity<&P::strokeOpacity>),
    inherited<&P::width>("stroke-width", setWidth),
    inherited<&P::miterLimit>("stroke-miterlimit", setMiterLimit),
    inherited<&P::dashOffset>("stroke-dashoffset", setDashOffset),
    inherited<&P::dashes>("stroke-dasharray", setDashes),
    inherited<&P::cap>("stroke-linecap", setCap),
    inherited<&P::join>("stroke-linejoin", setJoin),
    inherited<&P::fillRule>("fill-rule", setRule<&P::fillRule>),
    inherited<&P::clipRule>("clip-rule", setRule<&P::clipRule>),
    inherited<&P::linearColours>("color-interpolation", setInterpolation),
    inherited<&P::visible>("visibility", setVisibility),
    inherited<&P::paintOrder>("paint-order", setPaintOrder),
    inherited<&P::markerStart>("marker-start", setText<&P::markerStart>),
    inherited<&P::markerMid>("marker-mid", setText<&P::markerMid>),
    inherited<&P::markerEnd>("marker-end", setText<&P::markerEnd>),
    Property{"marker", setMarkers, copyMarkers, true, Property::Attribute::Other},
    own<&P::opacity>("opacity", setOpacity<&P::opacity>),
    own<&P::displayed>("display", setDisplay),
    Property{"overflow", setOverflow, copyOverflow},
    own<&P::fixedWidth>("vector-effect", setVectorEffect),
    own<&P::clipPath>("clip-path", setText<&P::clipPath>),
    own<&P::mask>("mask", setText<&P::mask>),
    inherited<&P::sharpPixels>("image-rendering", setImageRendering),
    own<&P::maskByAlpha>("mask-type", setMaskType),
    own<&P::filter>("filter", setText<&P::filter>),
    own<&P::blending>("mix-blend-mode", setBlending),
    own<&P::stopColour>("stop-color", setPaint<&P::stopColour>),
    own<&P::stopOpacity>("stop-opacity", setOpacity<&P::stopOpacity>),
    transforms<&T::functions>("transform", same),
    transforms<&T::origin>("transform-origin", same),
    transforms<&T::box>("transform-box", other),
    transforms<&T::translate>("translate", other),
    transforms<&T::rotate>("rotate", other),
    transforms<&T::scale>("scale", other),
    shape("x", setPosition<true>),
    shape("y", setPosition<true>),
    shape("cx", setPosition<true>),
    shape("cy", setPosition<true>),
    shape("r", setPosition<false>),
    shape("rx", setSize),
    shape("ry", setSize),
    shape("width", setSize),
    shape("height", setSize),
    shape("d", setOutline),
};

} // namespace

std::span<const Property> properties()
{
    static const auto all = [] {
        std::vector<Property> rows(allProperties.begin(), allProperties.end());
        rows.insert(rows.end(), textProperties().begin(), textProperties().end());
        return rows;
    }();
    return all;
}

const Property* findProperty(std::string_view name)
{
    static const auto index = [] {
        std::unordered_map<std::string_view, const Property*> map;
        for (const Property& property : properties())
            map.emplace(property.name, &property);
        return map;
    }();
    const auto found = index.find(name);
    return found == index.end() ? nullptr : found->second;
}

} // namespace app::svg

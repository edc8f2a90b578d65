// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/css_shape.h"

#include "app/formats/svg/arc.h"
#include "app/formats/svg/css_corners.h"
#include "app/formats/svg/path_data.h"
#include "app/formats/svg/scanner.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace app::svg {
namespace {

using CssWords = std::vector<std::string_view>;

bool isWord(std::string_view text, std::string_view word) { return equalsIgnoringCase(text, word); }

// A shape in its box, as far as it is read.
struct InBox {
    std::string_view arguments;
    const Box& box;
    const Lengths& lengths;

    std::optional<double> length(std::string_view text, double whole) const
    {
        return lacksUnit(text) ? std::nullopt : lengths.parse(text, whole);
    }
};

// "at": the words before and after it.
std::pair<CssWords, CssWords> dividedAtPlace(std::string_view text)
{
    CssWords words = wordsOf(text);
    const auto at = std::ranges::find_if(words, [](auto word) { return isWord(word, "at"); });
    CssWords after(at == words.end() ? at : at + 1, words.end());
    words.erase(at, words.end());
    return {words, after};
}

// How far from the beginning of the box's side; `far` counts from its end.
std::optional<double> placeOn(std::string_view word, int axis, const InBox& in, bool far = false)
{
    constexpr std::array<std::string_view, 2> begin{"left", "top"}, end{"right", "bottom"};
    const double size = in.box.size[axis];
    if (isWord(word, begin[std::size_t(axis)]))
        return 0;
    if (isWord(word, end[std::size_t(axis)]))
        return size;
    if (isWord(word, "center"))
        return size / 2;
    const auto length = in.length(word, size);
    return length && far ? size - *length : length;
}

// "center", "10px", "left 20%", "right 5px bottom 5px".
std::optional<Point> positionOf(CssWords words, const InBox& in)
{
    const auto is = [](std::string_view word, auto... names) {
        return (isWord(word, names) || ...);
    };
    if (words.empty())
        return in.box.min + in.box.size * 0.5;
    if (words.size() == 4) {
        if (is(words[0], "top", "bottom")) {
            std::swap(words[0], words[2]);
            std::swap(words[1], words[3]);
        }
        const auto x = placeOn(words[1], 0, in, is(words[0], "right"));
        const auto y = placeOn(words[3], 1, in, is(words[2], "bottom"));
        const bool named = is(words[0], "left", "right") && is(words[2], "top", "bottom");
        return x && y && named ? std::optional(in.box.min + Point{*x, *y}) : std::nullopt;
    }
    if (words.size() == 1)
        words.push_back("center");
    if (is(words[0], "top", "bottom") || is(words[1], "left", "right"))
        std::swap(words[0], words[1]);
    const auto x = placeOn(words[0], 0, in), y = placeOn(words[1], 1, in);
    return x && y && words.size() == 2 ? std::optional(in.box.min + Point{*x, *y}) : std::nullopt;
}

PathShape ellipseAbout(const Point& centre, const Point& radii)
{
    if (!(radii.x > 0 && radii.y > 0))
        return {};
    const std::array places{centre + Point{radii.x, 0}, centre + Point{0, radii.y},
                            centre - Point{radii.x, 0}, centre - Point{0, radii.y}};
    Subpath path{places[0], {}, true};
    for (std::size_t i = 0; i < 4; ++i)
        appendArc(path.segments, {places[i], places[(i + 1) % 4], radii, 0, false, true});
    return {Path({&path, 1})};
}

// The distances of a place from the sides of the box: left, right, top, bottom.
std::array<double, 4> distancesOf(const Point& p, const Box& box)
{
    const Point max = box.min + box.size;
    return {std::abs(p.x - box.min.x), std::abs(p.x - max.x), std::abs(p.y - box.min.y),
            std::abs(p.y - max.y)};
}

// A radius of which 100% means `whole`, from its distances to sides.
std::optional<double> cssRadius(std::string_view word, double whole, std::span<const double> sides,
                                const InBox& in)
{
    if (isWord(word, "closest-side"))
        return std::ranges::min(sides);
    if (isWord(word, "farthest-side"))
        return std::ranges::max(sides);
    const auto radius = in.length(word, whole);
    return radius && *radius >= 0 ? radius : std::nullopt;
}

std::optional<PathShape> cssCircle(const InBox& in)
{
    const auto [words, place] = dividedAtPlace(in.arguments);
    const auto centre = positionOf(place, in);
    if (!centre || words.size() > 1)
        return std::nullopt;
    const double whole = std::hypot(in.box.size.x, in.box.size.y) / std::numbers::sqrt2;
    const auto radius = cssRadius(words.empty() ? "closest-side" : words[0], whole,
                                  distancesOf(*centre, in.box), in);
    return radius ? std::optional(ellipseAbout(*centre, Point(*radius))) : std::nullopt;
}

std::optional<PathShape> cssEllipse(const InBox& in)
{
    auto [words, place] = dividedAtPlace(in.arguments);
    const auto centre = positionOf(place, in);
    if (!centre || (!words.empty() && words.size() != 2))
        return std::nullopt;
    if (words.empty())
        words = {"closest-side", "closest-side"};
    const auto sides = distancesOf(*centre, in.box);
    const auto x = cssRadius(words[0], in.box.size.x, std::span(sides).first(2), in);
    const auto y = cssRadius(words[1], in.box.size.y, std::span(sides).last(2), in);
    return x && y ? std::optional(ellipseAbout(*centre, {*x, *y})) : std::nullopt;
}

// A box with the corners that follow "round".
std::optional<PathShape> boxWith(const Box& box, std::string_view corners, const InBox& in)
{
    const Box there{box.min, {std::max(box.size.x, 0.0), std::max(box.size.y, 0.0)}};
    const auto radii = corners.empty() ? std::optional(CornerRadii{})
                                       : cornerRadii(corners, there.size, in.lengths);
    if (!radii)
        return std::nullopt;
    const Subpath path = roundedBox(there, *radii);
    return PathShape{Path({&path, 1})};
}

// The words before "round", and the text after it.
std::pair<CssWords, std::string_view> dividedAtRound(std::string_view text)
{
    CssWords words = wordsOf(text);
    const auto at = std::ranges::find_if(words, [](auto word) { return isWord(word, "round"); });
    if (at == words.end())
        return {words, {}};
    const auto end = std::size_t(at->data() + at->size() - text.data());
    words.erase(at, words.end());
    const auto corners = trimmed(text.substr(end));
    return {words, corners.empty() ? "none" : corners};
}

std::optional<PathShape> cssInset(const InBox& in)
{
    const auto [words, corners] = dividedAtRound(in.arguments);
    if (words.empty() || words.size() > 4)
        return std::nullopt;
    std::array<double, 4> by{}; // top, right, bottom, left
    for (std::size_t i = 0; i < 4; ++i) {
        const std::size_t from = i < words.size()             ? i
                                 : i == 3 && words.size() > 1 ? 1
                                 : i == 2                     ? 0
                                                              : 0;
        const auto length = in.length(words[from], in.box.size[i % 2 == 0 ? 1 : 0]);
        if (!length)
            return std::nullopt;
        by[i] = *length;
    }
    const Point first{by[3], by[0]}, last{by[1], by[2]};
    return boxWith({in.box.min + first, in.box.size - first - last}, corners, in);
}

// "10px 90% auto 0": its sides, from the left and the top of the box.
std::optional<PathShape> cssRect(const InBox& in)
{
    const auto [words, corners] = dividedAtRound(in.arguments);
    if (words.size() != 4)
        return std::nullopt;
    std::array<double, 4> at{}; // top, right, bottom, left
    for (std::size_t i = 0; i < 4; ++i) {
        const double size = in.box.size[i % 2 == 0 ? 1 : 0];
        const auto length = isWord(words[i], "auto") ? std::optional(i == 1 || i == 2 ? size : 0)
                                                     : in.length(words[i], size);
        if (!length)
            return std::nullopt;
        at[i] = *length;
    }
    const Point first{at[3], at[0]}, last{at[1], at[2]};
    return boxWith({in.box.min + first, last - first}, corners, in);
}

std::optional<PathShape> cssXywh(const InBox& in)
{
    const auto [words, corners] = dividedAtRound(in.arguments);
    if (words.size() != 4)
        return std::nullopt;
    std::array<double, 4> numbers{};
    for (std::size_t i = 0; i < 4; ++i) {
        const auto length = in.length(words[i], in.box.size[int(i % 2)]);
        if (!length || (i >= 2 && *length < 0))
            return std::nullopt;
        numbers[i] = *length;
    }
    return boxWith({in.box.min + Point{numbers[0], numbers[1]}, {numbers[2], numbers[3]}}, corners,
                   in);
}

// Takes "evenodd," from the beginning.
FillRule takeRule(std::string_view& text)
{
    const auto comma = text.find(',');
    const auto first = trimmed(text.substr(0, comma));
    const bool evenOdd = isWord(first, "evenodd");
    if (comma != text.npos && (evenOdd || isWord(first, "nonzero")))
        text = trimmed(text.substr(comma + 1));
    return evenOdd ? FillRule::EvenOdd : FillRule::NonZero;
}

std::optional<PathShape> cssPolygon(const InBox& in)
{
    std::string_view text = in.arguments;
    PathShape shape{{}, takeRule(text)};
    Subpath path{{}, {}, true};
    for (bool isFirst = true; !text.empty(); isFirst = false) {
        const auto end = std::min(text.find(','), text.size());
        const auto words = wordsOf(text.substr(0, end));
        if (words.size() != 2)
            return std::nullopt;
        const auto x = in.length(words[0], in.box.size.x), y = in.length(words[1], in.box.size.y);
        if (!x || !y)
            return std::nullopt;
        const Point p = in.box.min + Point{*x, *y};
        if (isFirst)
            path.start = p;
        else
            path.segments.push_back({p});
        text = trimmed(text.substr(std::min(end + 1, text.size())));
    }
    shape.path = Path({&path, 1});
    return path.segments.empty() ? std::nullopt : std::optional(std::move(shape));
}

std::optional<PathShape> cssPath(const InBox& in)
{
    std::string_view text = in.arguments;
    const FillRule rule = takeRule(text);
    if (text.size() < 2 || (text.front() != '"' && text.front() != '\'')
        || text.back() != text.front())
        return std::nullopt;
    Outline outline = parsePathData(text.substr(1, text.size() - 2));
    if (outline.damaged)
        return std::nullopt;
    for (Subpath& path : outline.paths)
        svg::transform(path, translation(in.box.min));
    return PathShape{Path(outline.paths), rule};
}

struct ShapeFunction {
    std::string_view name;
    std::optional<PathShape> (*shape)(const InBox& in);
};
constexpr std::array shapeFunctions{
    ShapeFunction{"circle", cssCircle}, ShapeFunction{"ellipse", cssEllipse},
    ShapeFunction{"inset", cssInset},   ShapeFunction{"rect", cssRect},
    ShapeFunction{"xywh", cssXywh},     ShapeFunction{"polygon", cssPolygon},
    ShapeFunction{"path", cssPath},
};

constexpr std::array<std::string_view, 7> boxNames{
    "fill-box", "stroke-box", "view-box", "content-box", "padding-box", "border-box", "margin-box"};

bool isBox(std::string_view word)
{
    return std::ranges::any_of(boxNames, [&](auto name) { return isWord(word, name); });
}

} // namespace

std::optional<CssClip> parseCssClip(std::string_view text)
{
    text = trimmed(text);
    if (isBox(text))
        return CssClip{{}, {}, text};
    const auto open = text.find('('), close = text.rfind(')');
    if (open == text.npos || close == text.npos || close < open)
        return std::nullopt;
    const auto before = wordsOf(text.substr(0, open));
    const auto after = trimmed(text.substr(close + 1));
    if (before.empty() || before.size() > 2 || (before.size() == 2 && !after.empty()))
        return std::nullopt;
    const auto box = before.size() == 2 ? before[0] : after;
    if (!box.empty() && !isBox(box))
        return std::nullopt;
    return CssClip{before.back(), trimmed(text.substr(open + 1, close - open - 1)), box};
}

std::optional<PathShape> cssShape(const CssClip& clip, const Box& box, const Lengths& lengths)
{
    if (clip.function.empty()) {
        const Subpath path = roundedBox(box, {});
        return PathShape{Path({&path, 1})};
    }
    const auto row = std::ranges::find_if(shapeFunctions, [&](const ShapeFunction& each) {
        return isWord(each.name, clip.function);
    });
    if (row == shapeFunctions.end())
        return std::nullopt;
    return row->shape({clip.arguments, box, lengths});
}

} // namespace app::svg

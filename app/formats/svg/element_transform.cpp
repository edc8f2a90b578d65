// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/element_transform.h"

#include "app/formats/svg/scanner.h"

#include <algorithm>
#include <array>
#include <vector>

namespace app::svg {
namespace {

using TransformWords = std::vector<std::string_view>;

bool isOne(std::string_view word, std::initializer_list<std::string_view> words)
{
    return std::ranges::any_of(words, [&](auto each) { return equalsIgnoringCase(word, each); });
}

bool isNone(std::string_view text) { return text.empty() || equalsIgnoringCase(text, "none"); }

// A place along one axis of the box: "left", "25%", "3px".
std::optional<double> placeOf(std::string_view word, const TransformUnits& units, int axis)
{
    if (isOne(word, {"left", "top"}))
        return 0;
    if (isOne(word, {"right", "bottom"}))
        return units.box[axis];
    if (isOne(word, {"center"}))
        return units.box[axis] / 2;
    return transformLength(word, units, axis);
}

// "center", "left 3px", "bottom right", "10px 20px 0".
std::optional<Point> originOf(std::string_view text, const TransformUnits& units)
{
    TransformWords words = wordsOf(text);
    if (words.empty())
        return Point{};
    if (words.size() == 1)
        words.push_back("center");
    if (isOne(words[0], {"top", "bottom"}) || isOne(words[1], {"left", "right"}))
        std::swap(words[0], words[1]);
    const bool crossed = isOne(words[0], {"top", "bottom"}) || isOne(words[1], {"left", "right"});
    const auto x = placeOf(words[0], units, 0), y = placeOf(words[1], units, 1);
    if (crossed || !x || !y || words.size() > 3)
        return std::nullopt;
    return Point{*x, *y}; // a third number is a depth
}

std::optional<Matrix> translateOf(std::string_view text, const TransformUnits& units)
{
    const TransformWords words = wordsOf(text);
    if (isNone(text))
        return Matrix{};
    const auto x = transformLength(words[0], units, 0);
    const auto y = words.size() > 1 ? transformLength(words[1], units, 1) : 0;
    return x && y && words.size() <= 2 ? std::optional(translation({*x, *y})) : std::nullopt;
}

// An angle, about the axis that points out of the page if any is named.
std::optional<Matrix> rotateOf(std::string_view text, const TransformUnits& units)
{
    TransformWords words = wordsOf(text);
    if (isNone(text))
        return Matrix{};
    if (words.size() == 2)
        std::erase_if(words, [](auto word) { return isOne(word, {"z"}); });
    if (words.size() != 1)
        return std::nullopt;
    return parseTransform("rotate(" + std::string(words[0]) + ')', units);
}

std::optional<Matrix> scaleOf(std::string_view text, const TransformUnits& units)
{
    const TransformWords words = wordsOf(text);
    if (isNone(text))
        return Matrix{};
    if (words.size() > 2)
        return std::nullopt;
    const std::string y = words.size() > 1 ? ',' + std::string(words[1]) : std::string();
    return parseTransform("scale(" + std::string(words[0]) + y + ')', units);
}

} // namespace

bool isPlain(const TransformTexts& texts)
{
    return texts.functions.text.empty() && texts.translate.text.empty() && texts.rotate.text.empty()
           && texts.scale.text.empty();
}

bool refersToBounds(const TransformTexts& texts)
{
    return isOne(texts.box.text, {"fill-box", "content-box"});
}

std::optional<Matrix> matrixOf(const TransformTexts& texts, const Lengths& lengths, const Box& box)
{
    if (!texts.box.text.empty() && !isOne(texts.box.text, {"view-box", "fill-box", "content-box"}))
        return std::nullopt;
    const auto unitsOf = [&](const TransformTexts::Written& written) {
        return TransformUnits{lengths, box.size, written.isCss};
    };
    const auto functions = parseTransform(texts.functions.text, unitsOf(texts.functions));
    const bool isUsual = texts.translate.text.empty() && texts.rotate.text.empty()
                         && texts.scale.text.empty() && texts.origin.text.empty();
    if (isUsual && box.min == Point{})
        return functions;
    const auto origin = originOf(texts.origin.text, unitsOf(texts.origin));
    const auto translate = translateOf(texts.translate.text, unitsOf(texts.translate));
    const auto rotate = rotateOf(texts.rotate.text, unitsOf(texts.rotate));
    const auto scale = scaleOf(texts.scale.text, unitsOf(texts.scale));
    if (!origin || !translate || !rotate || !scale || !functions)
        return std::nullopt;
    const Matrix all = *translate * *rotate * *scale * *functions;
    const Point about = box.min + *origin;
    return about == Point{} ? all : translation(about) * all * translation(-about);
}

} // namespace app::svg

// SPDX-License-Identifier: GPL-3.0-or-later
// The properties of letters.
#include "app/formats/svg/length.h"
#include "app/formats/svg/property.h"
#include "app/formats/svg/scanner.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace app::svg {
namespace {

using Letters = TextStyle;
using Word = std::string_view;

bool meansWord(Word value, Word word) { return equalsIgnoringCase(value, word); }

bool isOneOf(Word value, Word words)
{
    return std::ranges::any_of(wordsOf(words), [&](Word word) { return meansWord(value, word); });
}

struct SizeWord {
    Word word;
    double pixels;
};
constexpr std::array sizeWords{SizeWord{"xx-small", 9.6}, SizeWord{"x-small", 12},
                               SizeWord{"small", 14.222}, SizeWord{"medium", 16},
                               SizeWord{"large", 19.2},   SizeWord{"x-large", 24},
                               SizeWord{"xx-large", 32},  SizeWord{"xxx-large", 48}};

std::optional<double> sizeOf(Word text, double around, const Lengths& lengths)
{
    constexpr double step = 1.2;
    if (meansWord(text, "larger"))
        return around * step;
    if (meansWord(text, "smaller"))
        return around / step;
    const auto word = std::ranges::find_if(
        sizeWords, [&](const SizeWord& each) { return meansWord(text, each.word); });
    if (word != sizeWords.end())
        return word->pixels;
    const auto size = lengths.parse(text, around);
    return size && *size >= 0 ? size : std::nullopt;
}

bool setFontSize(Properties& p, Word text, const Given& given)
{
    const auto size = sizeOf(text, given.lengths.fontSize, given.lengths);
    if (size)
        p.fontSize = *size;
    return size.has_value();
}

bool setFamily(Properties& p, Word text, const Given&)
{
    p.text.families = text;
    return true;
}

bool setStyle(Properties& p, Word text, const Given&)
{
    const Word first = text.substr(0, text.find_first_of(blanks));
    const bool slanted = isOneOf(first, "italic oblique");
    if (slanted || meansWord(text, "normal"))
        p.text.italic = slanted;
    return slanted || meansWord(text, "normal");
}

// CSS Fonts 4, section 2.2.1.
int bolder(int weight) { return weight < 350 ? 400 : weight < 550 ? 700 : std::max(weight, 900); }
int lighter(int weight) { return weight < 550 ? std::min(weight, 100) : weight < 750 ? 400 : 700; }

std::optional<int> fontWeightOf(Word text, int around)
{
    if (meansWord(text, "normal"))
        return 400;
    if (meansWord(text, "bold"))
        return 700;
    if (meansWord(text, "bolder"))
        return bolder(around);
    if (meansWord(text, "lighter"))
        return lighter(around);
    const auto number = lacksUnit(text) ? Lengths().parse(text, 0) : std::nullopt;
    return number && *number >= 1 && *number <= 1000 ? std::optional(int(*number)) : std::nullopt;
}

bool setWeight(Properties& p, Word text, const Given&)
{
    const auto weight = fontWeightOf(text, p.text.weight);
    if (weight)
        p.text.weight = *weight;
    return weight.has_value();
}

bool setVariant(Properties& p, Word text, const Given& given)
{
    p.text.smallCapitals = meansWord(text, "small-caps");
    if (!isOneOf(text, "normal none small-caps"))
        p.text.notEvaluated = given.property;
    return true;
}

bool setKerning(Properties& p, Word text, const Given&)
{
    const bool none = meansWord(text, "none"), known = none || isOneOf(text, "auto normal");
    if (known)
        p.text.kerning = !none;
    return known;
}

/// The property of SVG 1.1. A length other than 0 would be a gap between all letters.
bool setOldKerning(Properties& p, Word text, const Given& given)
{
    const bool none = given.lengths.parse(text, p.fontSize) == 0.0;
    const bool known = none || meansWord(text, "auto");
    if (known)
        p.text.kerning = !none;
    return known;
}

template <auto spacing>
bool setSpacing(Properties& p, Word text, const Given& given)
{
    if (text.ends_with('%')) // of the viewport in SVG 1.1, of the font in CSS Text 4
        return false;
    const auto length = meansWord(text, "normal") ? 0 : given.lengths.parse(text, p.fontSize);
    if (length)
        p.text.*spacing = *length;
    return length.has_value();
}

/// Of CSS, and of SVG 1.1.
bool setWritingMode(Properties& p, Word text, const Given&)
{
    const bool vertical = isOneOf(text, "vertical-rl vertical-lr tb tb-rl tb-lr");
    const bool known = vertical || isOneOf(text, "horizontal-tb lr lr-tb rl rl-tb");
    if (known)
        p.text.vertical = vertical;
    return known;
}

bool setAnchor(Properties& p, Word text, const Given&)
{
    using Anchor = TextStyle::Anchor;
    for (const auto& [word, anchor] :
         {std::pair{"start", Anchor::Start}, {"middle", Anchor::Middle}, {"end", Anchor::End}})
        if (meansWord(text, word)) {
            p.text.anchor = anchor;
            return true;
        }
    return false;
}

bool setDirection(Properties& p, Word text, const Given&)
{
    if (!isOneOf(text, "ltr rtl"))
        return false;
    p.text.rightToLeft = meansWord(text, "rtl");
    return true;
}

bool setWhiteSpace(Properties& p, Word text, const Given&)
{
    p.text.keepsBlanks = isOneOf(text, "pre pre-wrap break-spaces preserve");
    return isOneOf(text, "normal nowrap pre pre-wrap pre-line break-spaces preserve collapse");
}

constexpr Word knownBaselines = "auto alphabetic baseline middle central hanging mathematical "
                                "ideographic text-before-edge text-after-edge before-edge "
                                "after-edge text-top text-bottom top bottom center use-script "
                                "no-change reset-size";

template <auto member>
bool setBaseline(Properties& p, Word text, const Given&)
{
    const bool known = isOneOf(text, knownBaselines);
    if (known)
        p.*member = isOneOf(text, "auto baseline") ? Word() : text;
    return known;
}
bool setDominantBaseline(Properties& p, Word text, const Given&)
{
    const bool known = isOneOf(text, knownBaselines);
    if (known && !isOneOf(text, "no-change use-script reset-size"))
        p.text.baseline = isOneOf(text, "auto baseline") ? Word() : text;
    return known;
}

// Upwards, in user units.
bool setBaselineShift(Properties& p, Word text, const Given& given)
{
    using Script = Properties::Script;
    const bool isSub = meansWord(text, "sub"), isSuper = meansWord(text, "super");
    const auto shift =
        isSub || isSuper || meansWord(text, "baseline") ? 0 : given.lengths.parse(text, p.fontSize);
    if (shift) {
        p.baselineShift = *shift;
        p.script = isSub ? Script::Below : isSuper ? Script::Above : Script::None;
    }
    return shift.has_value();
}

void copyBaselineShift(Properties& to, const Properties& from)
{
    to.baselineShift = from.baselineShift;
    to.script = from.script;
}

bool setDecoration(Properties& p, Word text, const Given& given)
{
    p.text.lines = 0;
    for (const Word word : wordsOf(text)) {
        if (meansWord(word, "underline"))
            p.text.lines |= Letters::underline;
        else if (meansWord(word, "overline"))
            p.text.lines |= Letters::overline;
        else if (meansWord(word, "line-through"))
            p.text.lines |= Letters::lineThrough;
        else if (!isOneOf(word, "none solid auto currentcolor"))
            p.text.notEvaluated = given.property;
    }
    return true;
}

bool setCase(Properties& p, Word text, const Given& given)
{
    p.text.letterCase = meansWord(text, "uppercase")   ? Letters::Case::Upper
                        : meansWord(text, "lowercase") ? Letters::Case::Lower
                                                       : Letters::Case::AsWritten;
    if (!isOneOf(text, "none uppercase lowercase"))
        p.text.notEvaluated = given.property;
    return true;
}

// "italic small-caps bold 12px/1.5 Arial, serif"; what it does not say is as usual.
bool setFont(Properties& p, Word text, const Given& given)
{
    if (isOneOf(text, "caption icon menu message-box small-caption status-bar"))
        return true;
    Properties made = p;
    made.text.italic = made.text.smallCapitals = false;
    made.text.kerning = true;
    made.text.weight = 400;
    for (text = trimmed(text); !text.empty(); text = trimmed(text)) {
        const auto end = std::min(text.find_first_of(blanks), text.size());
        const Word word = text.substr(0, end);
        if (const auto size =
                sizeOf(word.substr(0, word.find('/')), given.lengths.fontSize, given.lengths);
            size && !fontWeightOf(word, 400)) {
            made.fontSize = *size;
            text = trimmed(text.substr(end));
            if (text.starts_with('/')) // "12px / 1.5 Arial"
                text = trimmed(text.substr(std::min(text.find_first_of(blanks, 2), text.size())));
            made.text.families = text;
            if (!text.empty())
                p = std::move(made);
            return !text.empty();
        }
        if (!setStyle(made, word, given) && !setWeight(made, word, given)
            && !isOneOf(word, "small-caps condensed semi-condensed expanded"))
            return false;
        made.text.smallCapitals = made.text.smallCapitals || meansWord(word, "small-caps");
        text = text.substr(end);
    }
    return false;
}

/// Properties that change letters and are not evaluated, with the values that change nothing.
struct NotEvaluated {
    Word name, without;
};
constexpr std::array notEvaluated{
    NotEvaluated{"font-feature-settings", "normal"},
    NotEvaluated{"font-size-adjust", "none"},
    NotEvaluated{"font-stretch", "normal 100%"},
    NotEvaluated{"font-variant-alternates", "normal"},
    NotEvaluated{"font-variant-caps", "normal"},
    NotEvaluated{"font-variant-east-asian", "normal"},
    NotEvaluated{"font-variant-ligatures", "normal"},
    NotEvaluated{"font-variant-numeric", "normal"},
    NotEvaluated{"font-variant-position", "normal"},
    NotEvaluated{"font-variation-settings", "normal"},
    NotEvaluated{"glyph-orientation-horizontal", "0 0deg auto"},
    NotEvaluated{"glyph-orientation-vertical", "0 0deg auto"},
    NotEvaluated{"inline-size", "0 auto"},
    NotEvaluated{"shape-inside", "none auto"},
    NotEvaluated{"text-combine-upright", "none"},
    NotEvaluated{"text-emphasis", "none"},
    NotEvaluated{"text-indent", "0 0px"},
    NotEvaluated{"text-orientation", "mixed"},
    NotEvaluated{"text-rendering", "auto optimizelegibility geometricprecision"},
    NotEvaluated{"text-shadow", "none"},
    NotEvaluated{"unicode-bidi", "normal embed isolate plaintext"},
};

bool setNotEvaluated(Properties& p, Word text, const Given& given)
{
    const auto row = std::ranges::find(notEvaluated, given.property, &NotEvaluated::name);
    if (!isOneOf(text, row->without))
        p.text.notEvaluated = row->name;
    else if (p.text.notEvaluated == row->name)
        p.text.notEvaluated = {};
    return true;
}

template <auto member>
void copyText(Properties& to, const Properties& from)
{
    to.text.*member = from.text.*member;
}

template <auto member>
constexpr Property letters(Word name, decltype(Property::set) set)
{
    return {name, set, copyText<member>, true};
}

void copyFont(Properties& to, const Properties& from)
{
    to.fontSize = from.fontSize;
    to.text.families = from.text.families;
    to.text.weight = from.text.weight;
    to.text.italic = from.text.italic;
    to.text.smallCapitals = from.text.smallCapitals;
    to.text.kerning = from.text.kerning;
}

const std::array evaluated{
    Property{"font", setFont, copyFont, true, Property::Attribute::Other},
    Property{"font-size", setFontSize,
             [](Properties& to, const Properties& from) { to.fontSize = from.fontSize; }, true},
    letters<&Letters::families>("font-family", setFamily),
    letters<&Letters::italic>("font-style", setStyle),
    letters<&Letters::weight>("font-weight", setWeight),
    letters<&Letters::smallCapitals>("font-variant", setVariant),
    Property{"font-kerning", setKerning, copyText<&Letters::kerning>, true,
             Property::Attribute::Other},
    letters<&Letters::kerning>("kerning", setOldKerning),
    letters<&Letters::letterSpacing>("letter-spacing", setSpacing<&Letters::letterSpacing>),
    letters<&Letters::wordSpacing>("word-spacing", setSpacing<&Letters::wordSpacing>),
    letters<&Letters::anchor>("text-anchor", setAnchor),
    letters<&Letters::rightToLeft>("direction", setDirection),
    letters<&Letters::vertical>("writing-mode", setWritingMode),
    letters<&Letters::keepsBlanks>("white-space", setWhiteSpace),
    letters<&Letters::baseline>("dominant-baseline", setDominantBaseline),
    letters<&Letters::lines>("text-decoration", setDecoration),
    letters<&Letters::lines>("text-decoration-line", setDecoration),
    letters<&Letters::letterCase>("text-transform", setCase),
    Property{"alignment-baseline", setBaseline<&Properties::alignment>,
             [](Properties& to, const Properties& from) { to.alignment = from.alignment; }},
    Property{"baseline-shift", setBaselineShift, copyBaselineShift},
};

} // namespace

std::span<const Property> textProperties()
{
    static const auto all = [] {
        std::vector<Property> rows(evaluated.begin(), evaluated.end());
        for (const NotEvaluated& row : notEvaluated)
            rows.push_back({row.name, setNotEvaluated, copyText<&Letters::notEvaluated>, true});
        return rows;
    }();
    return all;
}

} // namespace app::svg

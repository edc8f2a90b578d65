// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/colour.h"

#include "app/formats/svg/colour_spaces.h"
#include "app/formats/svg/length.h"
#include "app/formats/svg/refused.h"
#include "app/formats/svg/scanner.h"

#include <QColor>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace app::svg {
namespace {

std::uint8_t byte(double part) // part: 0 to 1
{
    return std::uint8_t(std::lround(std::clamp(part, 0.0, 1.0) * 255));
}

std::optional<Colour> fromHex(std::string_view digits)
{
    std::uint32_t value = 0;
    const auto [end, error] =
        std::from_chars(digits.data(), digits.data() + digits.size(), value, 16);
    if (error != std::errc{} || end != digits.data() + digits.size() || digits.front() == '-')
        return std::nullopt;
    const auto one = [&](int shift) { return std::uint8_t((value >> shift & 0xf) * 0x11); };
    const auto two = [&](int shift) { return std::uint8_t(value >> shift & 0xff); };
    switch (digits.size()) {
    case 3:
        return Colour{one(8), one(4), one(0)};
    case 4:
        return Colour{one(12), one(8), one(4), one(0)};
    case 6:
        return Colour{two(16), two(8), two(0)};
    case 8:
        return Colour{two(24), two(16), two(8), two(0)};
    default:
        return std::nullopt;
    }
}

struct Parts {
    std::array<double, 4> value{0, 0, 0, 1};
    std::array<bool, 4> percent{};
};

// A word such as "none", which counts as 0.
bool takeNone(Scanner& in)
{
    const bool none = equalsIgnoringCase(in.rest().substr(0, 4), "none");
    if (none)
        in.word();
    return none;
}

std::optional<Parts> parseParts(Scanner& in)
{
    Parts parts;
    std::size_t count = 0;
    for (in.skipBlanks(); !in.take(')'); in.skipSeparator()) {
        if (in.take('/'))
            in.skipBlanks();
        const bool none = takeNone(in);
        const auto number = none ? std::optional(0.0) : in.number();
        if (!number || count == 4)
            return std::nullopt;
        parts.value[count] = *number;
        parts.percent[count] = in.take('%');
        const auto degrees = degreesOf(in.word());
        if (!degrees)
            return std::nullopt;
        parts.value[count++] *= *degrees;
    }
    in.skipBlanks();
    return count >= 3 && in.atEnd() ? std::optional(parts) : std::nullopt;
}

Colour fromRgb(const Parts& p)
{
    const auto part = [&](std::size_t i) { return byte(p.value[i] / (p.percent[i] ? 100 : 255)); };
    return {part(0), part(1), part(2)};
}

// CSS Color 3, section 4.2.4.
Colour fromHsl(const Parts& p)
{
    const double saturation = std::clamp(p.value[1] / 100, 0.0, 1.0);
    const double lightness = std::clamp(p.value[2] / 100, 0.0, 1.0);
    const double reach = saturation * std::min(lightness, 1 - lightness);
    const auto part = [&](double shift) {
        const double raw = std::fmod(shift + p.value[0] / 30, 12);
        const double k = raw < 0 ? raw + 12 : raw;
        return byte(lightness - reach * std::max(-1.0, std::min({k - 3, 9 - k, 1.0})));
    };
    return {part(0), part(8), part(4)};
}

// CSS Color 4, section 8.2.
Colour fromHwb(const Parts& p)
{
    const double white = std::clamp(p.value[1] / 100, 0.0, 1.0);
    const double black = std::clamp(p.value[2] / 100, 0.0, 1.0);
    if (white + black >= 1)
        return Colour{byte(white / (white + black)), byte(white / (white + black)),
                      byte(white / (white + black))};
    const Colour hue = fromHsl({{p.value[0], 100, 50, 1}, {}});
    const auto part = [&](std::uint8_t of) {
        return byte(of / 255.0 * (1 - white - black) + white);
    };
    return {part(hue.red), part(hue.green), part(hue.blue)};
}

// A part in percent of `whole`, or as it is.
double partOf(const Parts& p, std::size_t i, double whole)
{
    return p.percent[i] ? p.value[i] * whole / 100 : p.value[i];
}

Colour fromFractions(const SrgbParts& parts)
{
    return {byte(parts[0]), byte(parts[1]), byte(parts[2])};
}
Colour fromLab(const Parts& p)
{
    return fromFractions(srgbOfLab({partOf(p, 0, 100), partOf(p, 1, 125), partOf(p, 2, 125)}));
}
Colour fromLch(const Parts& p)
{
    const double chroma = partOf(p, 1, 150);
    return fromFractions(srgbOfLab(fromPolar({partOf(p, 0, 100), chroma, p.value[2]})));
}
Colour fromOklab(const Parts& p)
{
    return fromFractions(srgbOfOklab({partOf(p, 0, 1), partOf(p, 1, 0.4), partOf(p, 2, 0.4)}));
}
Colour fromOklch(const Parts& p)
{
    return fromFractions(srgbOfOklab(fromPolar({partOf(p, 0, 1), partOf(p, 1, 0.4), p.value[2]})));
}

// "color(display-p3 1 0.5 0 / 50%)".
std::optional<Colour> fromColourSpace(Scanner& in)
{
    in.skipBlanks();
    const auto space = in.rest().substr(0, in.rest().find_first_of(blanks));
    Scanner rest(in.rest().substr(space.size()));
    const auto parts = parseParts(rest);
    if (!parts)
        return std::nullopt;
    const auto srgb =
        srgbOfSpace(space, {partOf(*parts, 0, 1), partOf(*parts, 1, 1), partOf(*parts, 2, 1)});
    if (!srgb)
        return std::nullopt;
    Colour colour = fromFractions(*srgb);
    colour.alpha = byte(partOf(*parts, 3, 1));
    return colour;
}

// "light-dark(white, black)": the first, as pictures are light.
std::optional<Colour> fromLight(Scanner& in)
{
    std::string_view rest = in.rest();
    const auto first = takeWord(rest, ",");
    return rest.ends_with(')') ? parseColour(first) : std::nullopt;
}

struct ColourFunction {
    std::string_view name;
    Colour (*colour)(const Parts&);
};
constexpr std::array colourFunctions{
    ColourFunction{"rgb", fromRgb},    ColourFunction{"rgba", fromRgb},
    ColourFunction{"hsl", fromHsl},    ColourFunction{"hsla", fromHsl},
    ColourFunction{"hwb", fromHwb},    ColourFunction{"lab", fromLab},
    ColourFunction{"lch", fromLch},    ColourFunction{"oklab", fromOklab},
    ColourFunction{"oklch", fromOklch}};

// Whether numbers stand beside percentages, which rgb() with commas does not allow.
bool mixesKinds(std::string_view function, const Parts& p)
{
    return function.starts_with("rgb")
           && (p.percent[0] != p.percent[1] || p.percent[0] != p.percent[2]);
}

std::optional<Colour> fromFunction(std::string_view text)
try {
    Scanner in(text);
    const auto name = in.word();
    if (equalsIgnoringCase(name, "color") && in.take('('))
        return fromColourSpace(in);
    if (equalsIgnoringCase(name, "light") && in.rest().substr(0, 6).ends_with('(')
        && equalsIgnoringCase(in.rest().substr(0, 5), "-dark")) {
        Scanner inside(in.rest().substr(6));
        return fromLight(inside);
    }
    const auto function = std::ranges::find_if(colourFunctions, [&](const ColourFunction& each) {
        return equalsIgnoringCase(each.name, name);
    });
    if (function == colourFunctions.end() || !in.take('('))
        return std::nullopt;
    const auto parts = parseParts(in);
    if (!parts || (text.find(',') != text.npos && mixesKinds(function->name, *parts)))
        return std::nullopt;
    Colour colour = function->colour(*parts);
    colour.alpha = byte(parts->value[3] / (parts->percent[3] ? 100 : 1));
    return colour;
} catch (const Refused&) { // a number is not finite
    return std::nullopt;
}

std::optional<Colour> fromName(std::string_view name)
{
    if (equalsIgnoringCase(name, "transparent"))
        return Colour{0, 0, 0, 0};
    if (equalsIgnoringCase(name, "rebeccapurple")) // from CSS 4; Qt knows only SVG's 147 names
        return Colour{0x66, 0x33, 0x99};
    const bool letters = std::ranges::all_of(
        name, [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); });
    const QColor colour = letters ? QColor::fromString(QLatin1StringView(name)) : QColor();
    if (!colour.isValid())
        return std::nullopt;
    return Colour{std::uint8_t(colour.red()), std::uint8_t(colour.green()),
                  std::uint8_t(colour.blue())};
}

} // namespace

std::optional<Colour> parseColour(std::string_view text)
{
    text = trimmed(text);
    if (text.empty())
        return std::nullopt;
    if (text.front() == '#')
        return text.size() > 1 ? fromHex(text.substr(1)) : std::nullopt;
    return text.find('(') == text.npos ? fromName(text) : fromFunction(text);
}

std::optional<double> parseOpacity(std::string_view text)
try {
    Scanner in(trimmed(text));
    auto number = in.number();
    if (!number)
        return std::nullopt;
    if (in.take('%'))
        *number /= 100;
    return in.atEnd() ? std::optional(std::clamp(*number, 0.0, 1.0)) : std::nullopt;
} catch (const Refused&) {
    return std::nullopt;
}

Colour faded(Colour colour, double opacity)
{
    colour.alpha = byte(colour.alpha / 255.0 * opacity);
    return colour;
}

std::string hexOf(const Colour& colour)
{
    constexpr std::string_view digits = "0123456789abcdef";
    std::string hex = "#";
    for (const std::uint8_t part : {colour.red, colour.green, colour.blue, colour.alpha}) {
        hex += digits[part >> 4];
        hex += digits[part & 15];
    }
    hex.resize(colour.alpha == 255 ? 7 : 9);
    return hex;
}

} // namespace app::svg

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/colour.h"

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

std::optional<Parts> parseParts(Scanner& in)
{
    Parts parts;
    std::size_t count = 0;
    for (in.skipBlanks(); !in.take(')'); in.skipSeparator()) {
        if (in.take('/'))
            in.skipBlanks();
        const auto number = in.number();
        if (!number || count == 4)
            return std::nullopt;
        parts.value[count] = *number;
        parts.percent[count] = in.take('%');
        in.word(); // consumes "deg"
        ++count;
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

std::optional<Colour> fromFunction(std::string_view text)
{
    Scanner in(text);
    const auto name = in.word();
    const bool rgb = equalsIgnoringCase(name.substr(0, 3), "rgb");
    const bool hsl = equalsIgnoringCase(name.substr(0, 3), "hsl");
    const auto rest = name.substr(std::min<std::size_t>(name.size(), 3));
    if (!(rgb || hsl) || !(rest.empty() || equalsIgnoringCase(rest, "a")) || !in.take('('))
        return std::nullopt;
    const auto parts = parseParts(in);
    if (!parts)
        return std::nullopt;
    Colour colour = rgb ? fromRgb(*parts) : fromHsl(*parts);
    colour.alpha = byte(parts->value[3] / (parts->percent[3] ? 100 : 1));
    return colour;
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
{
    Scanner in(trimmed(text));
    auto number = in.number();
    if (!number)
        return std::nullopt;
    if (in.take('%'))
        *number /= 100;
    return in.atEnd() ? std::optional(std::clamp(*number, 0.0, 1.0)) : std::nullopt;
}

Colour faded(Colour colour, double opacity)
{
    colour.alpha = byte(colour.alpha / 255.0 * opacity);
    return colour;
}

} // namespace app::svg

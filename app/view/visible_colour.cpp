// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/visible_colour.h"

#include <QColor>

#include <algorithm>
#include <array>
#include <cmath>

namespace app {
namespace {

constexpr double enough = 3.0;

double luminance(const Colour& c)
{
    const auto linear = [](std::uint8_t channel) {
        const double v = channel / 255.0;
        return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(c.red) + 0.7152 * linear(c.green) + 0.0722 * linear(c.blue);
}

Colour withLightness(const QColor& hue, float lightness, std::uint8_t alpha)
{
    const QColor c =
        QColor::fromHslF(std::max(0.0F, hue.hslHueF()), hue.hslSaturationF(), lightness);
    return {std::uint8_t(c.red()), std::uint8_t(c.green()), std::uint8_t(c.blue()), alpha};
}

Colour mixed(const Colour& colour, const Colour& page, double opacity)
{
    const auto channel = [=](std::uint8_t of, std::uint8_t with) {
        return std::uint8_t(std::lround(opacity * of + (1 - opacity) * with));
    };
    return {channel(colour.red, page.red), channel(colour.green, page.green),
            channel(colour.blue, page.blue), colour.alpha};
}

} // namespace

double contrast(const Colour& a, const Colour& b)
{
    const auto [dark, light] = std::minmax({luminance(a), luminance(b)});
    return (light + 0.05) / (dark + 0.05);
}

Colour visibleColour(const Colour& colour, const Colour& page)
{
    if (contrast(colour, page) >= enough)
        return colour;
    const QColor hue(colour.red, colour.green, colour.blue);
    const float step = luminance(page) < 0.18 ? 0.02F : -0.02F; // away from the page's lightness
    float lightness = 1 - hue.lightnessF();
    Colour shown = withLightness(hue, lightness, colour.alpha);
    while (contrast(shown, page) < enough && lightness + step >= 0 && lightness + step <= 1) {
        lightness += step;
        shown = withLightness(hue, lightness, colour.alpha);
    }
    return shown;
}

Colour ghostColour(const Colour& colour, const Colour& page, double opacity)
{
    while (opacity < 1 && contrast(mixed(colour, page, opacity), page) < enough)
        opacity += 0.02;
    return mixed(colour, page, std::min(opacity, 1.0));
}

namespace {

constexpr std::array<QRgb, 5> onLight{0xEEF5DF, 0xB4DCC3, 0x62B1BE, 0x2F6FA3, 0x1D2A66};
constexpr std::array<QRgb, 5> onDark{0x27345A, 0x2D6389, 0x419AA6, 0x8ACCB0, 0xF4F8D9};

int between(int from, int to, double share) { return int(std::lround(from + (to - from) * share)); }

double relativeLuminance(const QColor& colour)
{
    const auto linear = [](double x) {
        return x <= 0.04045 ? x / 12.92 : std::pow((x + 0.055) / 1.055, 2.4);
    };
    return 0.2126 * linear(colour.redF()) + 0.7152 * linear(colour.greenF())
           + 0.0722 * linear(colour.blueF());
}

} // namespace

QColor sequentialColour(double share, Ground ground)
{
    const auto& anchors = ground == Ground::Light ? onLight : onDark;
    const double place = std::clamp(share, 0.0, 1.0) * double(anchors.size() - 1);
    const auto below = std::min(std::size_t(place), anchors.size() - 2);
    const QRgb low = anchors[below], high = anchors[below + 1];
    const double rest = place - double(below);
    return {between(qRed(low), qRed(high), rest), between(qGreen(low), qGreen(high), rest),
            between(qBlue(low), qBlue(high), rest)};
}

QColor readableOn(const QColor& colour)
{
    constexpr double even = 0.179; // luminance at which black and white have equal contrast (WCAG)
    return relativeLuminance(colour) > even ? QColor(0x1B1E23) : QColor(Qt::white);
}

} // namespace app

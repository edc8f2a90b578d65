// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/sequential_scale.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace app {

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

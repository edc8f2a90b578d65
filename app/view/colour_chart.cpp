// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/colour_chart.h"

#include <QColor>

namespace app {
namespace {

struct Row {
    float saturation, lightness;
};
constexpr Row rows[]{{0.75F, 0.78F}, {1, 0.5F}, {0.85F, 0.32F}, {0.5F, 0.2F}};

Colour colourOf(const QColor& colour)
{
    return {std::uint8_t(colour.red()), std::uint8_t(colour.green()), std::uint8_t(colour.blue())};
}

} // namespace

std::vector<Colour> colourChart()
{
    std::vector<Colour> colours;
    for (int i = 0; i < coloursInRow; ++i) {
        const auto grey = std::uint8_t(255 * i / (coloursInRow - 1));
        colours.push_back({grey, grey, grey});
    }
    for (const Row& row : rows)
        for (int i = 0; i < coloursInRow; ++i)
            colours.push_back(
                colourOf(QColor::fromHslF(float(i) / coloursInRow, row.saturation, row.lightness)));
    return colours;
}

} // namespace app

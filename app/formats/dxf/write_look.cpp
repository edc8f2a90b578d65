// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/write_look.h"

#include "app/formats/dxf/aci.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace app::dxf::writing {
namespace {

constexpr std::array weights{0,  5,  9,  13, 15, 18,  20,  25,  30,  35,  40,  50,
                             53, 60, 70, 80, 90, 100, 106, 120, 140, 158, 200, 211};

constexpr double longestPattern = 1e100;

std::uint32_t rgbOf(const Colour& colour)
{
    return std::uint32_t(colour.red) << 16 | std::uint32_t(colour.green) << 8 | colour.blue;
}

int distanceOf(std::uint32_t a, std::uint32_t b)
{
    int sum = 0;
    for (const int shift : {0, 8, 16}) {
        const int step = int(a >> shift & 0xff) - int(b >> shift & 0xff);
        sum += step * step;
    }
    return sum;
}

} // namespace

int nearestAci(const Colour& colour)
{
    const std::uint32_t rgb = rgbOf(colour);
    if (rgb == 0)
        return blackOrWhite;
    const auto nearer = [&](std::uint32_t a, std::uint32_t b) {
        return distanceOf(a, rgb) < distanceOf(b, rgb);
    };
    return int(std::min_element(aciColours.begin() + 1, aciColours.end(), nearer)
               - aciColours.begin());
}

int lineWeightOf(double millimetres)
{
    const double wanted = std::min(millimetres * 100, double(weights.back()));
    const auto distance = [&](int weight) { return std::abs(weight - wanted); };
    return *std::ranges::min_element(weights, {}, distance);
}

LineTypes::LineTypes(const Document& document, double scale) : scale_(scale)
{
    const Objects& objects = document.objects();
    std::optional<StyleIndex> last;
    objects.forEach(0, objects.size(), [&](std::size_t, const ObjectView& object) {
        if (last == object.styleIndex())
            return;
        last = object.styleIndex();
        auto pattern = patternOf(object.style());
        if (pattern.empty() || !found_.emplace(pattern, all_.size()).second)
            return;
        std::string name = freeName(pattern);
        all_.push_back({std::move(name), std::move(pattern)});
    });
}

// The dashes and gaps that repeat; empty: the line is continuous.
std::vector<double> LineTypes::patternOf(const Style& style) const
{
    std::vector<double> pattern = style.dashes;
    if (pattern.size() % 2 == 1)
        pattern.insert(pattern.end(), style.dashes.begin(), style.dashes.end());
    double length = 0;
    for (double& part : pattern)
        length += part *= scale_;
    const bool has = style.stroke && length > 0 && length <= longestPattern;
    return has ? pattern : std::vector<double>();
}

// A usual name of such patterns, as some programs look at nothing but the name.
std::string LineTypes::freeName(const std::vector<double>& pattern) const
{
    const bool dotted = pattern.size() == 2 && pattern[0] * 3 <= pattern[1];
    const std::string stem = dotted                ? "DOT"
                             : pattern.size() == 2 ? "DASHED"
                             : pattern.size() == 4 ? "DASHDOT"
                                                   : "DIVIDE";
    const auto isTaken = [&](const std::string& name) {
        return std::ranges::find(all_, name, &LineType::name) != all_.end();
    };
    for (const char* usual : {"", "2", "X2"})
        if (!isTaken(stem + usual))
            return stem + usual;
    return stem + '-' + std::to_string(all_.size() + 1);
}

std::string_view LineTypes::nameOf(const Style& style) const
{
    const auto found = style.dashes.empty() ? found_.end() : found_.find(patternOf(style));
    return found == found_.end() ? std::string_view() : all_[found->second].name;
}

std::optional<LineLook> lookOf(const ObjectView& object, double millimetresPerUnit)
{
    const auto colour = lineColour(object);
    if (!colour || colour->alpha == 0)
        return std::nullopt;
    const double width = object.style().stroke ? object.style().width : 0;
    return LineLook{*colour, lineWeightOf(width * millimetresPerUnit)};
}

void writeLook(TagWriter& tags, const LineLook& look, Looks looks, bool on)
{
    const int index = nearestAci(look.colour);
    tags.whole(62, on ? index : -index);
    if (looks == Looks::IndexOnly)
        return;
    if (const std::uint32_t rgb = rgbOf(look.colour); aciColours[std::size_t(index)] != rgb)
        tags.whole(420, rgb);
    tags.whole(370, look.weight);
}

} // namespace app::dxf::writing

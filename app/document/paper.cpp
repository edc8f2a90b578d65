// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/paper.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace app {

std::span<const NamedPaper> namedPapers()
{
    static constexpr std::array all{
        NamedPaper{"A0", {841, 1189}},       NamedPaper{"A1", {594, 841}},
        NamedPaper{"A2", {420, 594}},        NamedPaper{"A3", {297, 420}},
        NamedPaper{"A4", {210, 297}},        NamedPaper{"A5", {148, 210}},
        NamedPaper{"A6", {105, 148}},        NamedPaper{"Letter", {215.9, 279.4}},
        NamedPaper{"Legal", {215.9, 355.6}}, NamedPaper{"Tabloid", {279.4, 431.8}},
    };
    return all;
}

const NamedPaper* paperNamed(std::string_view name)
{
    const auto found = std::ranges::find(namedPapers(), name, &NamedPaper::name);
    return found == namedPapers().end() ? nullptr : &*found;
}

const NamedPaper* namedPaperOf(const Page& page)
{
    constexpr double slack = 0.05; // millimetres: files in other units are rounded
    const auto near = [](const Point& a, const Point& b) {
        return std::abs(a.x - b.x) <= slack && std::abs(a.y - b.y) <= slack;
    };
    const Point size = millimetresOf(page);
    const auto found = std::ranges::find_if(namedPapers(), [&](const NamedPaper& paper) {
        return near(paper.millimetres, size) || near(paper.millimetres, {size.y, size.x});
    });
    return found == namedPapers().end() ? nullptr : &*found;
}

Point millimetresOf(const Page& page)
{
    const double unit = page.millimetresPerUnit();
    const auto side = [unit](const Length& length, double units) {
        const double millimetres = length.value * infoOf(length.unit).millimetres;
        return millimetres > 0 ? millimetres : units * unit;
    };
    return {side(page.width, page.size.x), side(page.height, page.size.y)};
}

} // namespace app

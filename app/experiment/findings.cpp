// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/findings.h"

#include "app/base/random.h"

#include <algorithm>
#include <cmath>

namespace app {
namespace {

double stepFor(const clipping::Window& w)
{
    const double largest = std::max(
        {std::abs(w.min.x), std::abs(w.min.y), std::abs(w.max.x), std::abs(w.max.y), 1e-300});
    return std::exp2(std::ilogb(largest) - 16);
}

std::uint64_t pieceChecksum(const clipping::Clipped& line, double step, std::uint64_t first)
{
    const auto of = [&](const glm::dvec2& p) {
        const auto rounded = [&](double x) { return std::nearbyint(x / step) + 0.0; }; // never -0
        return mixed(mixed(rounded(p.x)) + mixed(mixed(rounded(p.y))));
    };
    return mixed(first + line.source) * (of(line.segment.a) + of(line.segment.b));
}

} // namespace

Findings added(Findings so, std::span<const clipping::Clipped> found,
               std::span<const clipping::Clipped> exactPieces, const clipping::Window& window,
               std::uint64_t first)
{
    const double step = stepFor(window);
    std::uint64_t agreed = 0;
    auto next = exactPieces.begin();
    for (const clipping::Clipped& line : found) {
        so.checksum += pieceChecksum(line, step, first);
        while (next != exactPieces.end() && next->source < line.source)
            ++next;
        agreed += next != exactPieces.end() && next->source == line.source;
    }
    so.visible += found.size();
    so.shown += found.size() - agreed;
    so.lost += exactPieces.size() - agreed;
    return so;
}

} // namespace app

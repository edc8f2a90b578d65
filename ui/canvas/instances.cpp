// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/instances.h"

#include <algorithm>

namespace ui {
namespace {

enum : std::uint32_t { Butt, Round, Square };

constexpr double edgeWidth = 0.5;

std::uint32_t packed(const app::Colour& c)
{
    return std::uint32_t(c.red) | std::uint32_t(c.green) << 8 | std::uint32_t(c.blue) << 16
           | std::uint32_t(c.alpha) << 24;
}

std::uint32_t capOf(app::Cap cap)
{
    return cap == app::Cap::Round ? Round : cap == app::Cap::Square ? Square : Butt;
}

class Batching {
public:
    explicit Batching(const glm::dvec2& viewSize) : middle_(viewSize.x / 2, viewSize.y / 2) {}

    void stroke(std::span<const QPointF> points, const app::Chain& chain, const app::Ink& ink)
    {
        const std::uint32_t join = ink.colour.alpha == 255 ? Round : Butt, cap = capOf(ink.cap);
        const auto end = [&](bool own) {
            return chain.closed ? join : own ? cap : std::uint32_t(Butt);
        };
        for (std::size_t i = 1; i < points.size(); ++i) {
            const std::uint32_t a = i == 1 ? end(chain.capAtStart) : join;
            const std::uint32_t b = i + 1 == points.size() ? end(chain.capAtEnd) : join;
            const QPointF from = points[i - 1] - middle_, to = points[i] - middle_;
            result.instances.push_back({float(from.x()), float(from.y()), float(to.x()),
                                        float(to.y()), packed(ink.colour), float(ink.width),
                                        a | b << 2});
        }
    }

    void fill(const app::Plate& plate, const app::Coat& coat)
    {
        result.batches.push_back(
            {true, std::uint32_t(result.contourStarts.size()), coat.chains, coat.fill, coat.rule});
        for (const app::Chain& chain : plate.chainsOf(coat)) {
            result.contourStarts.push_back(std::int32_t(result.points.size()));
            result.contourCounts.push_back(std::int32_t(chain.count));
            for (const QPointF& p : plate.pointsOf(chain))
                result.points.push_back({float(p.x() - middle_.x()), float(p.y() - middle_.y())});
        }
    }

    void closeStrokes(std::size_t first)
    {
        const auto count = std::uint32_t(result.instances.size() - first);
        auto& all = result.batches;
        if (count == 0)
            return;
        if (!all.empty() && !all.back().filled)
            all.back().count += count;
        else
            all.push_back({false, std::uint32_t(first), count});
    }

    Batches result;

private:
    QPointF middle_;
};

} // namespace

Batches batches(const app::Plate& plate, const glm::dvec2& viewSize)
{
    Batching batching(viewSize);
    for (const app::Coat& coat : plate.coats) {
        if (!coat.stroke)
            batching.fill(plate, coat);
        const std::size_t first = batching.result.instances.size();
        const app::Ink edge{coat.fill, edgeWidth, app::Cap::Butt, app::Join::Round, 4};
        if (coat.stroke || coat.fill.alpha == 255)
            for (const app::Chain& chain : plate.chainsOf(coat))
                batching.stroke(plate.pointsOf(chain), chain, coat.stroke.value_or(edge));
        batching.closeStrokes(first);
    }
    return std::move(batching.result);
}

} // namespace ui

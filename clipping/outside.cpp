// SPDX-License-Identifier: MIT
#include "clipping/outside.h"

#include "clipping/ieee_numbers.h"
#include "clipping/limits.h"

namespace clipping {

// Whether a piece has the opposite direction; Skala's published form returns such pieces.
static bool isTurned(const Segment& part, const Segment& whole)
{
    const glm::dvec2 p = part.b - part.a, w = whole.b - whole.a;
    return p.x * w.x + p.y * w.y < 0;
}

std::size_t outsideAll(std::span<const Segment> in, std::span<const Clipped> inside,
                       std::span<Clipped> out) noexcept
{
    if (out.size() < in.size() + inside.size()) [[unlikely]]
        refuse(in.size() + inside.size(), out.size());
    std::size_t written = 0;
    auto next = inside.begin();
    for (std::size_t i = 0; i < in.size(); ++i) {
        const auto source = static_cast<std::uint32_t>(i);
        const Segment& whole = in[i];
        const Clipped* part = next != inside.end() && next->source == source ? &*next++ : nullptr;
        const bool touch = part && part->segment.a == part->segment.b && whole.a != whole.b;
        if (!part || touch) {
            out[written++] = {whole, source, 0};
            continue;
        }
        const bool turned = isTurned(part->segment, whole);
        const Segment inner = turned ? Segment{part->segment.b, part->segment.a} : part->segment;
        const Edge enter = turned ? cutEdgeOfB(part->cut) : cutEdgeOfA(part->cut);
        const Edge leave = turned ? cutEdgeOfA(part->cut) : cutEdgeOfB(part->cut);
        if (inner.a != whole.a)
            out[written++] = {{whole.a, inner.a}, source, cutAt(Edge::NoEdge, enter)};
        if (inner.b != whole.b)
            out[written++] = {{inner.b, whole.b}, source, cutAt(leave, Edge::NoEdge)};
    }
    return written;
}

} // namespace clipping

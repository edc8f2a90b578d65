// SPDX-License-Identifier: MIT
#include "clipping/outside.h"

#include <cassert>

namespace clipping {

std::size_t outsideAll(std::span<const Segment> in, std::span<const Clipped> inside,
                       std::span<Clipped> out)
{
    assert(out.size() >= in.size() + inside.size());
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
        if (part->segment.a != whole.a)
            out[written++] = {
                {whole.a, part->segment.a}, source, cutAt(Edge::None, cutEdgeOfA(part->cut))};
        if (part->segment.b != whole.b)
            out[written++] = {
                {part->segment.b, whole.b}, source, cutAt(cutEdgeOfB(part->cut), Edge::None)};
    }
    return written;
}

} // namespace clipping

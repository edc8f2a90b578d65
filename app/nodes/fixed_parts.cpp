// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/fixed_parts.h"

namespace app {
namespace {

bool sameSegment(const NodeSubpath& before, const NodeSubpath& after, std::size_t i)
{
    const std::size_t next = (i + 1) % before.nodes.size();
    const Node &from = before.nodes[i], &to = before.nodes[next];
    const Node &fromNow = after.nodes[i], &toNow = after.nodes[next];
    const bool sameHandles = !from.curved || (from.out == fromNow.out && to.in == toNow.in);
    return from.at == fromNow.at && to.at == toNow.at && from.curved == fromNow.curved
           && sameHandles;
}

} // namespace

std::vector<Subpath> fixedParts(const NodeSubpath& before, const NodeSubpath& after)
{
    std::vector<Subpath> parts;
    if (before.nodes.size() != after.nodes.size())
        return parts;
    std::vector<bool> shown(before.nodes.size());
    for (std::size_t i = 0; i < before.segmentCount(); ++i) {
        if (!sameSegment(before, after, i))
            continue;
        const Bezier s = before.segment(i);
        const bool curved = before.nodes[i].curved;
        parts.push_back(
            {s.from,
             {curved ? PathSegment{s.to, s.control1, s.control2, true} : PathSegment{s.to}},
             false});
        shown[i] = shown[(i + 1) % shown.size()] = true;
    }
    for (std::size_t i = 0; i < shown.size(); ++i)
        if (const Point& at = before.nodes[i].at; !shown[i] && at == after.nodes[i].at)
            parts.push_back({at, {{at}}, false});
    return parts;
}

} // namespace app

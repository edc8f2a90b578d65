// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmarks/clip/agreement.h"

#include "clipping/algorithm.h"

#include <glm/common.hpp>

#include <algorithm>

namespace {

double distance(const glm::dvec2& p, const glm::dvec2& q)
{
    const auto d = glm::abs(p - q);
    return std::max(d.x, d.y);
}

bool holds(const clipping::Window& w, const glm::dvec2& p)
{
    return p.x >= w.min.x && p.x <= w.max.x && p.y >= w.min.y && p.y <= w.max.y;
}

} // namespace

Agreement agreementOf(const PeerData& peer, const clipping::Window& window, std::size_t count)
{
    const auto exact = clipping::exactAlgorithm().corrected.clip;
    Agreement result;
    result.compared = std::min(count, peer.size());
    for (std::size_t i = 0; i < result.compared; ++i) {
        const auto theirs = peer.clip(i), ours = exact(peer.given(i), window);
        result.visible += theirs ? 1 : 0;
        result.onlyPeer += theirs && !ours ? 1 : 0;
        result.onlyExact += ours && !theirs ? 1 : 0;
        if (theirs && !(holds(window, theirs->a) && holds(window, theirs->b)))
            ++result.outside;
        if (theirs && ours)
            result.largest = std::max(
                {result.largest, distance(theirs->a, ours->a), distance(theirs->b, ours->b)});
    }
    return result;
}

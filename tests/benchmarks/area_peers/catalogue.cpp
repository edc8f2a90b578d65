// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "tests/benchmarks/area_peers/peer.h"

// Each in a file of its own, which CMake leaves out where the library is missing: then the weak
// name is null.
[[gnu::weak]] std::span<const AreaPeer> clipperAreaPeers();
[[gnu::weak]] std::span<const AreaPeer> boostGeometryAreaPeers();

std::span<const AreaPeer> areaPeers()
{
    static const std::vector<AreaPeer> all = [] {
        std::vector<AreaPeer> installed;
        for (const auto peers : {clipperAreaPeers, boostGeometryAreaPeers})
            if (peers)
                installed.insert(installed.end(), peers().begin(), peers().end());
        return installed;
    }();
    return all;
}

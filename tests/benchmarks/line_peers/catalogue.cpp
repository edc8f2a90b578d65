// SPDX-License-Identifier: GPL-3.0-or-later
#include <vector>

#include "tests/benchmarks/line_peers/peer.h"

// Each in a file of its own, which CMake leaves out where the library is missing: then the weak
// name is null.
[[gnu::weak]] std::span<const LinePeer> geosLinePeers();
[[gnu::weak]] std::span<const LinePeer> clipperLinePeers();
[[gnu::weak]] std::span<const LinePeer> boostGeometryLinePeers();

std::span<const LinePeer> linePeers()
{
    static const std::vector<LinePeer> all = [] {
        std::vector<LinePeer> installed;
        for (const auto peers : {geosLinePeers, clipperLinePeers, boostGeometryLinePeers})
            if (peers)
                installed.insert(installed.end(), peers().begin(), peers().end());
        return installed;
    }();
    return all;
}

std::span<const std::string_view> missingLinePeers()
{
    static const std::vector<std::string_view> all = [] {
        std::vector<std::string_view> missing;
        if (!geosLinePeers)
            missing.push_back("GEOS (libgeos++-dev)");
        if (!clipperLinePeers)
            missing.push_back("Clipper 6.4 (libpolyclipping-dev)");
        if (!boostGeometryLinePeers)
            missing.push_back("Boost.Geometry (libboost-dev)");
        return missing;
    }();
    return all;
}

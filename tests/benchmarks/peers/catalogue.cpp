// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmarks/peers/peer.h"

// Each in a file of its own, which CMake leaves out where the library is missing: then the weak
// name is null.
[[gnu::weak]] std::span<const Peer> openCvPeers();
[[gnu::weak]] std::span<const Peer> aggPeers();
[[gnu::weak]] std::span<const Peer> boostGeometryPeers();
[[gnu::weak]] std::span<const Peer> cgalPeers();
[[gnu::weak]] std::span<const Peer> geosPeers();

std::span<const PeerLibrary> peerLibraries()
{
    static const PeerLibrary all[] = {
        {"OpenCV", "libopencv-dev", openCvPeers},
        {"AGG", "libagg-dev", aggPeers},
        {"Boost.Geometry", "libboost-dev", boostGeometryPeers},
        {"CGAL", "libcgal-dev", cgalPeers},
        {"GEOS", "libgeos++-dev", geosPeers},
    };
    return all;
}

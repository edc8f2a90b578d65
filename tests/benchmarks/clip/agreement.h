// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>

#include "tests/benchmarks/peers/peer.h"

/// How a peer's results differ from those of `exact` on the segments that the peer was given.
struct Agreement {
    std::size_t compared = 0, visible = 0; ///< by the peer
    std::size_t onlyPeer = 0, onlyExact = 0;
    double largest = 0;      ///< difference of an end, in the drawing's units
    std::size_t outside = 0; ///< pieces with an end outside the window
};
struct NamedAgreement {
    std::string name;
    Agreement agreement;
    double endsWithin; ///< of the peer
    /// Whether it differs by at most 1 % of what can be seen, or of 1 % of all where that is less.
    bool plausible() const
    {
        const std::size_t visible = agreement.visible + agreement.onlyExact - agreement.onlyPeer;
        return 100 * (agreement.onlyPeer + agreement.onlyExact)
                   <= std::max(visible, agreement.compared / 100)
               && agreement.largest <= endsWithin;
    }
};

/// Compares every one of the first `count` segments.
Agreement agreementOf(const PeerData& peer, const clipping::Window& window, std::size_t count);

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/view/snapping/snap_offers.h"

#include <glm/geometric.hpp>

namespace app {

constexpr double sameDistance = 1e-9; // as a share of the radius

void SnapOffers::consider(const Snap& snap, SnapRank rank)
{
    const double distance = glm::distance(snap.point, pointer_);
    if (!(distance <= radius_))
        return;
    const bool better =
        !best_ || rank < rank_ || (rank == rank_ && distance < distance_ - sameDistance * radius_);
    if (!better)
        return;
    best_ = snap;
    rank_ = rank;
    distance_ = distance;
}

} // namespace app

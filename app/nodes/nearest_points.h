// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/path.h"

#include <optional>
#include <vector>

namespace app {

/// Points that are taken away one by one, and the nearest of those that are left: a k-d tree.
class NearestPoints {
public:
    struct Found {
        double distance;
        std::size_t point; ///< its number
    };

    /// Points are numbered from 0. O(n log n).
    explicit NearestPoints(std::vector<Point> points);

    void remove(std::size_t point); ///< once. O(log n)
    /// The nearest point to `point` that is left, at most that far away, except `point` itself and
    /// `other`; of several at the same distance the one with the least number. O(log n), plus the
    /// number of points at that distance.
    std::optional<Found> nearest(std::size_t point, double most, std::size_t other) const;

private:
    struct Search;
    void divide(std::size_t first, std::size_t end);
    void look(std::size_t first, std::size_t end, Search& search) const;

    // The middle of a range of points divides the others of the range by its x or y.
    std::vector<Point> points_;
    std::vector<std::uint32_t> order_, place_; ///< the points in the tree, and where each is
    std::vector<std::uint32_t> left_;          ///< of the range that this place is the middle of
    std::vector<std::uint8_t> axis_, gone_;    ///< of the point at each place
};

} // namespace app

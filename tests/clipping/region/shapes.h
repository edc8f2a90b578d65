// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/region/region.h"

#include <cmath>

#include "tests/clipping/random.h"

// Random areas and segments that are hard to decide.

/// Makes points of any size, of which many are near to, or the same as, an earlier one or on the
/// line through two of them.
class HostilePoints {
public:
    HostilePoints(Random& random, bool ordinary) : random_(random), ordinary_(ordinary) {}

    glm::dvec2 next()
    {
        const glm::dvec2 p = made();
        known_.push_back(p);
        return p;
    }

private:
    glm::dvec2 made()
    {
        if (known_.empty())
            return {number(), number()};
        const glm::dvec2 p = earlier(), q = earlier();
        switch (random_.whole(0, 6)) { // the kinds, each as likely
        case 0:
            return p;
        case 1:
            return nudgedPoint(p);
        case 2:
            return nudgedPoint(p / 2.0 + q / 2.0);
        case 3:
            return {p.x, q.y};
        case 4: {
            const double share = random_.unit();
            return p * (1 - share) + q * share;
        }
        default:
            return {number(), number()};
        }
    }
    double number()
    {
        return ordinary_ ? random_.whole(-8, 8) / random_.of(std::array{1.0, 3.0, 7.0})
                         : anyNumber(random_);
    }
    glm::dvec2 earlier() { return known_[std::size_t(random_.whole(0, int(known_.size()) - 1))]; }
    glm::dvec2 nudgedPoint(const glm::dvec2& p)
    {
        const auto nudgedNumber = [&](double x) {
            return ordinary_ && x == 0 ? x : finite(nudged(x, random_.whole(-2, 2)));
        };
        return {nudgedNumber(p.x), nudgedNumber(p.y)};
    }
    static double finite(double x) { return std::isfinite(x) ? x : Limits<double>::max(); }

    Random& random_;
    bool ordinary_;
    std::vector<glm::dvec2> known_;
};

inline clipping::Region hostileRegion(Random& random, HostilePoints& points, int most)
{
    using namespace clipping;
    Region region{{}, random.whole(0, 3) ? Keep::Inside : Keep::Outside};
    for (int n = random.whole(1, most); n > 0; --n) {
        Area area{{}, {}, random.whole(0, 1) ? FillRule::NonZero : FillRule::EvenOdd};
        for (int i = random.whole(3, 6); i > 0; --i)
            area.points.push_back(points.next());
        region.steps.push_back({std::move(area), AreaOperation(random.whole(0, 5) % 3)});
    }
    return region;
}

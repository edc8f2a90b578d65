// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/path.h"

#include <bit>
#include <cstdint>
#include <vector>

#include "tests/clipping/random.h"

// Paths of random subpaths, and all their numbers bit by bit.

class RandomPaths {
public:
    /// One number in `specialOneIn` is -0, huge, tiny or denormal. The others are between -10 and
    /// 10, half of them whole.
    explicit RandomPaths(unsigned seed, int specialOneIn = 8)
        : random(seed), specialOneIn_(specialOneIn)
    {
    }

    double number()
    {
        if (random.whole(1, specialOneIn_) == 1)
            return anyNumber(random);
        return random.whole(0, 1) ? random.whole(-10, 10) : random.between(-10, 10);
    }
    app::Point point()
    {
        const double x = number();
        return {x, number()};
    }
    app::Subpath subpath(int segments, bool curves)
    {
        app::Subpath subpath{point(), {}, random.whole(0, 2) == 0};
        for (int i = 0; i < segments; ++i) {
            const bool back = random.whole(0, 5) == 0; // closes it, or has no length
            app::PathSegment segment{back ? subpath.start : point()};
            if (curves && random.whole(0, 1)) {
                segment.control1 = point();
                segment.control2 = point();
                segment.curved = true;
            }
            subpath.segments.push_back(segment);
        }
        return subpath;
    }
    std::vector<app::Subpath> subpaths()
    {
        std::vector<app::Subpath> subpaths;
        const bool curves = random.whole(0, 1);
        const int count = random.whole(0, 5) ? 1 : random.whole(0, 4);
        for (int i = 0; i < count; ++i)
            subpaths.push_back(subpath(random.whole(0, 2) ? random.whole(0, 2) : 12, curves));
        return subpaths;
    }

    Random random;

private:
    int specialOneIn_;
};

using Bits = std::vector<std::uint64_t>;

inline void add(Bits& bits, const app::Point& p)
{
    bits.push_back(std::bit_cast<std::uint64_t>(p.x));
    bits.push_back(std::bit_cast<std::uint64_t>(p.y));
}

inline Bits bitsOf(const std::vector<app::Subpath>& subpaths)
{
    Bits bits;
    for (const app::Subpath& subpath : subpaths) {
        bits.push_back(subpath.segments.size() << 1 | std::uint64_t(subpath.closed));
        add(bits, subpath.start);
        for (const app::PathSegment& segment : subpath.segments) {
            bits.push_back(segment.curved);
            for (const app::Point& p : {segment.control1, segment.control2, segment.to})
                add(bits, p);
        }
    }
    return bits;
}

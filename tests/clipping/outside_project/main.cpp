// SPDX-License-Identifier: MIT
#include "clipping/algorithm.h"
#include "clipping/outside.h"

#include <cstdio>
#include <vector>

int main()
{
    const std::vector<clipping::Segment> lines{{{-2, 0}, {2, 0}}, {{5, 5}, {6, 6}}};
    const clipping::Window window{{-1, -1}, {1, 1}};
    for (const clipping::Algorithm& algorithm : clipping::algorithms()) {
        std::vector<clipping::Clipped> inside(lines.size());
        inside.resize(algorithm.corrected.clipAll(lines, window, inside));
        if (inside.size() != 1 || inside[0].segment != clipping::Segment{{-1, 0}, {1, 0}})
            return std::fprintf(stderr, "%s is wrong\n", algorithm.name.data()), 1;
    }
}

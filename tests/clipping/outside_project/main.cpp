// SPDX-License-Identifier: MIT
// Compiled with -ffast-math by tests/CMakeLists.txt, as a program may be that uses the library.
#include "clipping/algorithm.h"
#include "clipping/outside.h"

#include <cstdio>
#include <limits>
#include <vector>

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

const std::vector<clipping::Segment> lines{{{-2, 0}, {2, 0}},
                                           {{5, 5}, {6, 6}},
                                           {{notANumber, 0}, {2, 0}},
                                           {{-2, 0}, {0, notANumber}},
                                           {{-infinity, 0}, {infinity, 0}},
                                           {{0, 0}, {infinity, infinity}}};
const clipping::Window window{{-1, -1}, {1, 1}};

/// Only the first line is visible.
bool isRight(const clipping::Algorithm& algorithm)
{
    std::vector<clipping::Clipped> inside(lines.size());
    inside.resize(algorithm.corrected.clipAll(lines, window, inside));
    if (inside.size() != 1 || inside[0].segment != clipping::Segment{{-1, 0}, {1, 0}})
        return false;
    for (std::size_t i = 1; i < lines.size(); ++i)
        if (algorithm.corrected.clip(lines[i], window))
            return false;
    return true;
}

} // namespace

int main()
{
    for (const clipping::Algorithm& algorithm : clipping::algorithms())
        if (!isRight(algorithm))
            return std::fprintf(stderr, "%s is wrong\n", algorithm.name.data()), 1;
    return clipping::algorithms().empty();
}

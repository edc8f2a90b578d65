// SPDX-License-Identifier: MIT
// Gives the catalogue a buffer that is too short: it must end the program, with a sentence.
#include "clipping/algorithm.h"

#include <array>
#include <csignal>
#include <cstdlib>

int main()
{
    std::signal(SIGABRT, [](int) { std::_Exit(0); });
    const std::array<clipping::Segment, 3> in{};
    std::array<clipping::Clipped, 2> out;
    clipping::findAlgorithm("md")->corrected.clipAll(in, {{0, 0}, {1, 1}}, out);
}

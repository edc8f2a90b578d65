// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/benchmarks/clip/machine.h"

#include "clipping/batch/kernels.h"

#include <cstdio>
#include <fstream>
#include <string>
#include <thread>

#include "tests/benchmarks/peers/peer.h"

namespace {

std::string processor()
{
    std::ifstream file("/proc/cpuinfo");
    for (std::string line; std::getline(file, line);)
        if (line.starts_with("model name"))
            return line.substr(line.find(": ") + 2);
    return "unknown";
}

std::string instructions()
{
    std::string all;
    for (const auto& set : clipping::instructionSets())
        all += (all.empty() ? "" : ", ") + std::string(set.name)
               + (set.available ? "" : " (not on this machine)");
    return all;
}

void printMissingPeers()
{
    for (const PeerLibrary& library : peerLibraries())
        if (!library.peers)
            std::printf("- %s was not found when this was built (Debian: %s)\n",
                        library.name.data(), library.package.data());
}

} // namespace

void printMachine()
{
    std::printf("- processor: %s, %u of it; kernels: %s\n", processor().c_str(),
                std::thread::hardware_concurrency(), instructions().c_str());
    std::printf("- compiler: %s, flags %s\n", COMPILER, COMPILER_FLAGS);
    printMissingPeers();
}

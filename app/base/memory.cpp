// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/memory.h"

#include "app/base/numbers.h"
#include "app/base/text.h"

#include <algorithm>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <sys/resource.h>
#include <unistd.h>

namespace app {
namespace {

constexpr std::uint64_t unlimited = std::numeric_limits<std::uint64_t>::max();
constexpr std::uint64_t mostReserved = 200'000'000; // bytes

std::uint64_t difference(std::uint64_t most, std::uint64_t used)
{
    return most > used ? most - used : 0;
}

/// The number in a file of the kernel that follows `name`, or the first one; empty if there is none
/// ("max").
std::optional<std::uint64_t> numberIn(const std::string& path, const std::string& name = {})
{
    std::ifstream file(path);
    for (std::string word; !name.empty() && word != name;)
        if (!(file >> word))
            return std::nullopt;
    std::uint64_t number = 0;
    return file >> number ? std::optional(number) : std::nullopt;
}

std::uint64_t availableInSystem()
{
    const auto kilobytes = numberIn("/proc/meminfo", "MemAvailable:");
    return kilobytes ? *kilobytes * 1024 : unlimited;
}

/// The bytes that the control groups of the process (version 2) leave: its own and those around it.
/// Cached files do not count as used, because the kernel drops them when memory is needed.
std::uint64_t leftByGroups()
{
    std::ifstream groups("/proc/self/cgroup");
    std::string path;
    for (std::string line; std::getline(groups, line);)
        if (line.starts_with("0::"))
            path = line.substr(3);
    std::uint64_t left = unlimited;
    for (; path.size() > 1; path.resize(path.rfind('/'))) {
        const std::string group = "/sys/fs/cgroup" + path;
        const auto most = numberIn(group + "/memory.max"),
                   used = numberIn(group + "/memory.current"),
                   cached = numberIn(group + "/memory.stat", "inactive_file");
        if (most && used)
            left = std::min(left, difference(*most, difference(*used, cached.value_or(0))));
    }
    return left;
}

std::uint64_t leftByLimit()
{
    rlimit limit{};
    if (::getrlimit(RLIMIT_AS, &limit) != 0 || limit.rlim_cur == RLIM_INFINITY)
        return unlimited;
    const auto pages = numberIn("/proc/self/statm");
    return difference(limit.rlim_cur, pages.value_or(0) * std::uint64_t(::sysconf(_SC_PAGESIZE)));
}

/// Bytes that a drawing must not take: the program and others need some.
std::uint64_t reserveOf(std::uint64_t free) { return std::min(free / 10, mostReserved); }

QString gigabytes(std::uint64_t bytes)
{
    return Text::tr("%1 GB").arg(numberText(double(bytes) * 1e-9, 1));
}

} // namespace

std::uint64_t freeMemory()
{
    return std::min({availableInSystem(), leftByGroups(), leftByLimit()});
}

MemoryWatch::MemoryWatch() : reserve_(reserveOf(freeMemory())) {}

bool MemoryWatch::isEnough()
{
    constexpr unsigned each = 1U << 17U; // a look takes some 50 µs, so many rows 50 ms
    return ++calls_ % each != 0 || freeMemory() >= reserve_;
}

QString memoryFault(std::uint64_t needed)
{
    const std::uint64_t all = freeMemory(), free = all - reserveOf(all);
    if (needed <= free)
        return {};
    return Text::tr("it needs about %1 of memory, and %2 are free. Close other programs, or split "
                    "the file.")
        .arg(gigabytes(needed), gigabytes(free));
}

QString memoryEnds()
{
    return Text::tr("does not fit into the memory that is free. Close other programs, or split the "
                    "file.");
}

} // namespace app

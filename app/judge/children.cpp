// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/judge/children.h"

#include <charconv>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <string>
#include <unistd.h>

namespace app::plug_in {
namespace {

/// Reads the fourth field of the process's line in /proc, after the name, which may contain
/// anything; 0 if the process has ended.
pid_t parentOf(pid_t process)
{
    std::ifstream stat("/proc/" + std::to_string(process) + "/stat");
    const std::string line(std::istreambuf_iterator<char>(stat), {});
    const std::size_t name = line.rfind(')');
    if (name == std::string::npos)
        return 0;
    std::istringstream fields(line.substr(name + 1));
    char state = 0;
    pid_t parent = 0;
    return fields >> state >> parent ? parent : 0;
}

} // namespace

std::optional<std::vector<pid_t>> listedChildren()
{
    std::ifstream list("/proc/self/task/" + std::to_string(::getpid()) + "/children");
    if (!list)
        return std::nullopt;
    return std::vector<pid_t>(std::istream_iterator<pid_t>(list), {});
}

std::vector<pid_t> scannedChildren()
{
    std::vector<pid_t> found;
    std::error_code error;
    std::filesystem::directory_iterator entry("/proc", error);
    for (; !error && entry != std::filesystem::directory_iterator(); entry.increment(error)) {
        const std::string name = entry->path().filename().string();
        pid_t process = 0;
        const auto read = std::from_chars(name.data(), name.data() + name.size(), process);
        if (read.ec == std::errc() && read.ptr == name.data() + name.size()
            && parentOf(process) == ::getpid())
            found.push_back(process);
    }
    return found;
}

std::vector<pid_t> ownChildren()
{
    auto listed = listedChildren();
    return listed ? std::move(*listed) : scannedChildren();
}

} // namespace app::plug_in

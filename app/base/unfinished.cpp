// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/unfinished.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstring>
#include <unistd.h>

namespace app {
namespace {

// A signal handler reads these, so they are plain memory.
std::array<char, 4096> unfinished;     // the beginning of the temporary file's path
std::atomic<int> unfinishedLength = 0; // 0: no such file
constexpr int mostFiles = 100;         // an upper bound of open files; the program opens three
static_assert(decltype(unfinishedLength)::is_always_lock_free);

} // namespace

// Calls only async-signal-safe functions. Without /proc it does nothing.
void removeUnfinished()
{
    char link[] = "/proc/self/fd/00";
    std::array<char, std::tuple_size_v<decltype(unfinished)> + 16> path;
    const int begins = unfinishedLength;
    for (int file = 0; begins > 0 && file < mostFiles; ++file) {
        char* const digits = link + sizeof link - 3;
        digits[0] = file < 10 ? char('0' + file) : char('0' + file / 10);
        digits[1] = file < 10 ? '\0' : char('0' + file % 10);
        const auto length = ::readlink(link, path.data(), path.size() - 1);
        if (length <= begins
            || std::memcmp(path.data(), unfinished.data(), std::size_t(begins)) != 0)
            continue;
        path[std::size_t(length)] = '\0';
        ::unlink(path.data());
    }
}

// Where the file system does not support unnamed files, QSaveFile writes PATH.XXXXXX and renames it
// at the end. Symbolic links are followed.
Unfinished::Unfinished(const QString& path)
{
    const QFileInfo info(path), target(info.isSymLink() ? info.symLinkTarget() : path);
    const QByteArray begin =
        QFile::encodeName(target.dir().canonicalPath() + u'/' + target.fileName() + u'.');
    if (std::size_t(begin.size()) > unfinished.size())
        return;
    std::ranges::copy(begin, unfinished.begin());
    unfinishedLength = int(begin.size());
}

Unfinished::~Unfinished() { unfinishedLength = 0; }

} // namespace app

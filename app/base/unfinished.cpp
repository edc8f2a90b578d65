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

// The handler of a signal reads these, so they are plain memory.
std::array<char, 4096> unfinished;     // how the path of the half file begins
std::atomic<int> unfinishedLength = 0; // 0: there is none
constexpr int mostFiles = 100;         // that are open; we open three
static_assert(decltype(unfinishedLength)::is_always_lock_free);

} // namespace

// Only with functions that a signal may interrupt and call. Where there is no /proc it does
// nothing.
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

// Where the file system has no unnamed files, QSaveFile writes PATH.XXXXXX and renames it at the
// end; a link to a file is followed.
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/log_records.h"

#include "app/recovery/journal_base.h"
#include "app/recovery/journal_folder.h"

#include <QFile>

#include <algorithm>

namespace app {

std::string contentsOf(const QString& path, qint64 most)
{
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return {};
    std::string bytes(std::size_t(std::min(most, file.size())), '\0');
    bytes.resize(std::size_t(std::max<qint64>(0, file.read(bytes.data(), qint64(bytes.size())))));
    return bytes;
}

Reach forEachRecord(const QString& folder, int generation, std::uint64_t next,
                    const std::function<bool(std::string_view)>& follow)
{
    Reach reach{next, true};
    for (; QFile::exists(logFile(folder, generation)); ++generation) {
        const std::string bytes = contentsOf(logFile(folder, generation));
        FrameReader frames = recordsOf(bytes, reach.end);
        while (const auto record = frames.next()) {
            if (!follow(*record))
                return {reach.end, false};
            reach.end = frames.number();
        }
        reach.whole = reach.whole && frames.atEnd();
    }
    return reach;
}

} // namespace app

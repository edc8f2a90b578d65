// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/save.h"

#include "app/base/unfinished.h"
#include "app/formats/format.h"

#include <QCoreApplication>
#include <QFileInfo>

#include <new>

namespace app {

Saved save(const Document& document, const QString& path, const std::stop_token& stop)
{
    const Unfinished guard(path);
    try {
        WriteOptions options;
        options.stop = stop;
        if (const auto error = writeFile(document, path, options))
            return {stop.stop_requested() ? Saved::End::Stopped : Saved::End::Failed, *error};
        return {Saved::End::Written, {}, QFileInfo(path).lastModified()};
    } catch (const std::bad_alloc&) {
        return {Saved::End::Failed,
                QCoreApplication::translate("Session", "Cannot write %1: there is not enough "
                                                       "memory. Close other programs, and save "
                                                       "again.")
                    .arg(path)};
    }
}

} // namespace app

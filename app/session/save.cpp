// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/save.h"

#include "app/base/text.h"
#include "app/base/unfinished.h"
#include "app/formats/format.h"

#include <QFileInfo>

namespace app {

Saved save(const Document& document, const QString& path, const std::stop_token& stop)
{
    const Unfinished guard(path);
    WriteOptions options;
    options.stop = stop;
    const auto write = [&] { return writeFile(document, path, options); };
    const QString outOfMemory = Text::tr("Cannot write %1: there is not enough memory. Close other "
                                         "programs, and save again.")
                                    .arg(path);
    Saved saved{resultOf(write, stop, outOfMemory)};
    if (saved.end == Saved::End::Written)
        saved.fileTime = QFileInfo(path).lastModified();
    return saved;
}

} // namespace app

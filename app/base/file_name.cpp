// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/file_name.h"

#include "app/base/text.h"

#include <QFileInfo>

namespace app {

std::optional<QString> faultOfName(const QString& path)
{
    // Qt replaces each byte that is not UTF-8 by U+FFFD; but a file may really have that in its
    // name.
    if (!path.contains(QChar::ReplacementCharacter) || QFileInfo::exists(path))
        return std::nullopt;
    return Text::tr("its name is not UTF-8. Give it another name.");
}

} // namespace app

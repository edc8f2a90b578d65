// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/file_name.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace app {

std::optional<QString> faultOfName(const QString& path)
{
    // Qt puts U+FFFD for each byte that is not UTF-8; a file may really have that name.
    if (!path.contains(QChar::ReplacementCharacter) || QFileInfo::exists(path))
        return std::nullopt;
    return QCoreApplication::translate("formats", "its name is not UTF-8. Give it another name.");
}

} // namespace app

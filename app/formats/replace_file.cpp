// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/replace_file.h"

#include <QFileInfo>
#include <QSaveFile>

namespace app {
namespace {

std::optional<QString> writeTo(QFileDevice& file,
                               const std::function<std::optional<QString>(QIODevice& out)>& write,
                               bool (*finish)(QFileDevice&))
{
    if (!file.open(QIODevice::WriteOnly))
        return file.errorString() + u'.';
    if (auto error = write(file))
        return error;
    return finish(file) ? std::nullopt : std::optional(file.errorString() + u'.');
}

} // namespace

std::optional<QString>
replaceFile(const QString& path, const std::function<std::optional<QString>(QIODevice& out)>& write)
{
    const QFileInfo info(path);
    if (info.exists() && !info.isFile() && !info.isDir()) { // never replace a device by a file
        QFile device(path);
        return writeTo(device, write, [](QFileDevice& file) { return file.flush(); });
    }
    QSaveFile file(path);
    return writeTo(file, write,
                   [](QFileDevice& saved) { return static_cast<QSaveFile&>(saved).commit(); });
}

} // namespace app

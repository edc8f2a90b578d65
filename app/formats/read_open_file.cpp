// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/read_open_file.h"

#include "app/base/replace_file.h"
#include "app/base/text.h"

#include <QFileInfo>

namespace app {

Result<Imported> readOpenFile(QFileDevice& file, const Format& format, const ReadOptions& options)
{
    // A read error is treated as the end of the file. After a part, only the next read says it.
    auto result = format.readWith ? format.readWith(file, options) : format.read(file);
    if (!file.isSequential())
        file.getChar(nullptr);
    if (file.error() == QFileDevice::NoError)
        return result;
    return Result<Imported>::failure(
        Text::tr("it cannot be read to its end. %1.").arg(file.errorString()));
}

std::optional<QString> faultToOpen(const QString& path)
{
    const QFileInfo info(path);
    if (info.isDir())
        return Text::tr("it is a folder. Name a file in it.");
    if (auto fault = faultOfName(path))
        return fault;
    if (!info.exists())
        return Text::tr("there is no such file.");
    return std::nullopt;
}

const Format* formatToRead(const QString& path)
{
    return QFileInfo(path).suffix().toLower() == u"dwg" ? findFormat(u"dxf") : formatOfFile(path);
}

} // namespace app

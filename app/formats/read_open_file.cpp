// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/read_open_file.h"

#include <QCoreApplication>
#include <QFileInfo>

namespace app {

Result<Imported> readOpenFile(QFileDevice& file, const Format& format)
{
    auto result = format.read(file); // treats a read error as the end of the file
    if (file.error() == QFileDevice::NoError)
        return result;
    return Result<Imported>::failure(
        QCoreApplication::translate("formats", "it cannot be read to its end. %1.")
            .arg(file.errorString()));
}

const Format* formatToRead(const QString& path)
{
    const bool compressed =
        QFileInfo(path).suffix().compare(QStringLiteral("svgz"), Qt::CaseInsensitive) == 0;
    return compressed ? findFormat(u"svg") : formatOfFile(path);
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/read_open_file.h"

#include <QCoreApplication>

namespace app {

Result<Imported> readOpenFile(QFileDevice& file, const Format& format)
{
    auto result = format.read(file); // which takes a read that fails for the end
    if (file.error() == QFileDevice::NoError)
        return result;
    return Result<Imported>::failure(
        QCoreApplication::translate("formats", "it cannot be read to its end. %1.")
            .arg(file.errorString()));
}

} // namespace app

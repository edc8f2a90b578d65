// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/whole_pipe.h"

#include "app/base/text.h"

#include <QIODevice>

namespace app {

Result<QByteArray> wholePipe(QIODevice& in, std::size_t most)
{
    QByteArray data;
    while (in.waitForReadyRead(-1) || !in.atEnd()) {
        const QByteArray more = in.read(qint64(1) << 20);
        if (more.isEmpty())
            break;
        data += more;
        if (std::size_t(data.size()) > most)
            return Result<QByteArray>::failure(
                Text::tr("it is larger than %1 bytes. Save it as a file first.").arg(most));
    }
    return Result<QByteArray>::of(std::move(data));
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/write_all.h"
#include "app/formats/csv/writer.h"

#include <QBuffer>
#include <QCoreApplication>

namespace app {
namespace {

/// The table of csv.h with blanks between its columns.
std::optional<QString> write(const Document& document, QIODevice& out, const WriteOptions& options)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    csv::write(document, buffer, options);
    QByteArray bytes = buffer.data();
    bytes.replace(',', ' ');
    const bool all = writeAll(out, {bytes.data(), std::size_t(bytes.size())});
    return all ? std::nullopt : std::optional(out.errorString() + u'.');
}

} // namespace

Format datFormat()
{
    return {"dat", QCoreApplication::translate("formats", "Lines for gnuplot"), nullptr, write,
            Holds::SeparateLines};
}

} // namespace app

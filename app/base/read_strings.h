// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDataStream>
#include <QStringList>

namespace app {

/// Reads a QStringList of at most `most` strings, else the stream's data are corrupt. The stream's
/// own operator reserves memory for as many as damaged data claim: 100 GB.
inline QStringList readStrings(QDataStream& stream, quint32 most)
{
    quint32 count = 0;
    stream >> count;
    if (count > most)
        stream.setStatus(QDataStream::ReadCorruptData);
    QStringList strings;
    for (quint32 i = 0; i < count && stream.status() == QDataStream::Ok; ++i) {
        QString string;
        stream >> string;
        strings << string;
    }
    return stream.status() == QDataStream::Ok ? strings : QStringList();
}

} // namespace app

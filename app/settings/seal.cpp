// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/seal.h"

#include <QCryptographicHash>

namespace app {
namespace {

QByteArray sumOf(const QByteArray& bytes)
{
    return QCryptographicHash::hash(bytes, QCryptographicHash::Sha1);
}

} // namespace

QByteArray sealed(const QByteArray& bytes) { return sumOf(bytes) + bytes; }

std::optional<QByteArray> unsealed(const QByteArray& bytes)
{
    static const qsizetype length = sumOf({}).size();
    const QByteArray content = bytes.mid(length);
    return bytes.size() >= length && sumOf(content) == bytes.first(length) ? std::optional(content)
                                                                           : std::nullopt;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/remembered.h"

#include <QCryptographicHash>
#include <QFileInfo>
#include <QSettings>

#include <algorithm>
#include <cmath>

namespace app {
namespace {

constexpr int longestPath = 4096; // characters

} // namespace

int rememberedNumber(const QString& key, int least, int most, int usual)
{
    // QVariant converts 1e300 to the whole number 0 and reports success.
    const double number = rememberedNumber(key, double(least), double(most), double(usual));
    return number == std::floor(number) ? int(number) : usual;
}

double rememberedNumber(const QString& key, double least, double most, double usual)
{
    bool isNumber = false;
    const double number = QSettings().value(key).toDouble(&isNumber);
    return isNumber && number >= least && number <= most ? number : usual; // NaN: usual
}

QString rememberedFolder(const QString& key, const QString& usual)
{
    const QString folder = QSettings().value(key).toString();
    return isUsablePath(folder) && QFileInfo(folder).isDir() ? folder : usual;
}

bool isUsablePath(const QString& path)
{
    const auto isControl = [](QChar c) { return c.category() == QChar::Other_Control; };
    return path.size() <= longestPath && QFileInfo(path).isAbsolute()
           && std::ranges::none_of(path, isControl);
}

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

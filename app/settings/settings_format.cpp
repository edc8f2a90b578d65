// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/settings_format.h"

#include "app/base/replace_file.h"

#include <QFile>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSettings>

#include <optional>

namespace app {
namespace {

constexpr qint64 mostBytes = 1'000'000;
const QString bytesKey = QStringLiteral("base64");
constexpr auto onlyUser = QFileDevice::ReadOwner | QFileDevice::WriteOwner;

QJsonValue jsonOf(const QVariant& value)
{
    if (value.typeId() == QMetaType::QByteArray)
        return QJsonObject{{bytesKey, QString::fromLatin1(value.toByteArray().toBase64())}};
    return QJsonValue::fromVariant(value);
}

/// Invalid if this program never writes such a value.
QVariant valueOfJson(const QJsonValue& json)
{
    if (json.isObject())
        return QByteArray::fromBase64(json.toObject().value(bytesKey).toString().toLatin1());
    if (json.isArray()) {
        QStringList texts;
        for (const auto& each : json.toArray())
            texts << each.toString();
        return texts;
    }
    return json.isNull() ? QVariant() : json.toVariant();
}

bool read(QIODevice& in, QSettings::SettingsMap& map)
{
    const QByteArray text = in.read(mostBytes + 1);
    if (text.size() > mostBytes)
        return false;
    const QJsonObject all = QJsonDocument::fromJson(text).object();
    for (auto each = all.begin(); each != all.end(); ++each)
        if (const QVariant value = valueOfJson(each.value()); value.isValid())
            map.insert(each.key(), value);
    return true;
}

bool write(QIODevice& out, const QSettings::SettingsMap& map)
{
    QJsonObject all;
    for (auto each = map.begin(); each != map.end(); ++each)
        all.insert(each.key(), jsonOf(each.value()));
    const auto filling = [text = QJsonDocument(all).toJson()](QIODevice& sink) {
        sink.write(text);
        return std::optional<QString>();
    };
    auto* const file = qobject_cast<QFileDevice*>(&out);
    if (!file)
        return false;
    file->setPermissions(onlyUser);
    return !fillToDisk(*file, filling);
}

} // namespace

void useSafeSettings()
{
    static const QSettings::Format format =
        QSettings::registerFormat(QStringLiteral("ini"), read, write);
    QSettings::setDefaultFormat(format);
    QFile::setPermissions(QSettings().fileName(), onlyUser); // an earlier version's had wider ones
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/ini_text.h"

#include <QRegularExpression>

#include <optional>

namespace app {
namespace {

constexpr qsizetype longestEscape = 6; // "x00e9" and the next character

/// The character of the escape sequence whose backslash ends before `at`; moves `at` behind it.
std::optional<QChar> unescaped(QStringView text, qsizetype& at)
{
    static const QRegularExpression form(
        QStringLiteral("^(?:x([0-9a-fA-F]{1,4})(?![0-9a-fA-F])|([0-7]{1,3})(?![0-7])|"
                       "([abfnrtv\"?'\\\\]))"));
    const auto found = form.match(text.mid(at, longestEscape));
    if (!found.hasMatch())
        return std::nullopt;
    at += found.capturedEnd();
    if (found.hasCaptured(3)) {
        static constexpr QStringView names = u"abfnrtv", meant = u"\a\b\f\n\r\t\v";
        const QChar name = found.capturedView(3).front();
        const qsizetype index = names.indexOf(name);
        return index < 0 ? name : meant[index];
    }
    return QChar(found.hasCaptured(2) ? found.capturedView(2).toUShort(nullptr, 8)
                                      : found.capturedView(1).toUShort(nullptr, 16));
}

/// The items between the commas; empty if QSettings does not write such a text.
std::optional<QStringList> itemsOf(QStringView text)
{
    QStringList items{QString()};
    bool quoted = false;
    qsizetype solid = 0; // the length of the last item without trailing blanks
    for (qsizetype at = 0; at < text.size();) {
        QChar c = text[at++];
        const bool blank = !quoted && c.isSpace();
        if (c == u'"') {
            quoted = !quoted;
            continue;
        }
        if (!quoted && c == u';')
            break; // a comment
        if (!quoted && c == u',') {
            items.back().truncate(solid);
            items << QString();
            solid = 0;
            continue;
        }
        if (c == u'\\') {
            const auto meant = unescaped(text, at);
            if (!meant)
                return std::nullopt;
            c = *meant;
        }
        if (!blank || solid > 0)
            items.back() += c;
        if (!blank)
            solid = items.back().size();
    }
    items.back().truncate(solid);
    return quoted ? std::nullopt : std::optional(items);
}

/// "@" begins a type name; "@@" begins a text that starts with "@".
bool namesType(const QString& item) { return item.startsWith(u'@') && !item.startsWith(u"@@"); }

/// Invalid if the value has a type that is not read.
QVariant valueOf(QStringList items)
{
    static const QString bytes = QStringLiteral("@ByteArray(");
    if (items.size() == 1 && items[0].startsWith(bytes) && items[0].endsWith(u')'))
        return items[0].sliced(bytes.size()).chopped(1).toLatin1();
    for (QString& item : items) {
        if (namesType(item))
            return {};
        if (item.startsWith(u'@'))
            item.remove(0, 1);
    }
    return items.size() == 1 ? QVariant(items[0]) : QVariant(items);
}

} // namespace

QSettings::SettingsMap settingsOfIni(const QByteArray& text)
{
    static const QRegularExpression section(QStringLiteral("^\\[(\\w+)\\]$")),
        setting(QStringLiteral("^([\\w\\\\]+)=(.*)$"));
    QSettings::SettingsMap map;
    QString group;
    for (const QByteArray& bytes : text.split('\n')) {
        const QString line = QString::fromUtf8(bytes).trimmed();
        if (const auto head = section.match(line); head.hasMatch()) {
            group = head.captured(1) == u"General" ? QString() : head.captured(1) + u'/';
        } else if (const auto match = setting.match(line); match.hasMatch()) {
            const auto items = itemsOf(match.capturedView(2));
            if (const QVariant value = items ? valueOf(*items) : QVariant(); value.isValid())
                map.insert(group + match.captured(1).replace(u'\\', u'/'), value);
        }
    }
    return map;
}

} // namespace app

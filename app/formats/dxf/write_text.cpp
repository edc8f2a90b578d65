// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/write_text.h"

namespace app::dxf::writing {
namespace {

constexpr qsizetype longestName = 200; // of 255, which leaves room for a number
constexpr char16_t firstAlike = 0xa0;  // in Unicode and in the code page

QString withoutReserved(const QString& name)
{
    static const QString reserved = QStringLiteral("<>/\\\":;?*|=`,'");
    QString legal;
    for (const QChar c : name.trimmed().left(longestName))
        legal += c.isSurrogate() || !c.isPrint() || reserved.contains(c) ? u'_' : c;
    return legal;
}

QString inAscii(const QString& text)
{
    QString ascii;
    for (const QChar c : text.normalized(QString::NormalizationForm_KD))
        if (!c.isMark())
            ascii += c.unicode() < 0x80 ? c : u'_';
    return ascii;
}

std::string inCodePage(const QString& text)
{
    std::string encoded;
    for (const QChar c : text) {
        const char16_t code = c.unicode();
        if (code < 0x80 || (code >= firstAlike && code <= 0xff))
            encoded += char(code);
        else
            encoded += QStringLiteral("\\U+%1")
                           .arg(int(code), 4, 16, QLatin1Char('0'))
                           .toUpper()
                           .toStdString();
    }
    return encoded;
}

} // namespace

std::string LayerNames::legal(const QString& name)
{
    QString stem = withoutReserved(name);
    if (version_ == DxfVersion::R12)
        stem = inAscii(stem);
    if (stem.isEmpty())
        stem = QStringLiteral("Layer");
    QString unique = stem;
    for (int number = 2; !taken_.insert(unique.toCaseFolded()).second; ++number)
        unique = QStringLiteral("%1 (%2)").arg(stem).arg(number);
    return inCodePage(unique);
}

} // namespace app::dxf::writing

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/dxf/text_code.h"

#include "app/formats/dxf/tables.h"

#include <QStringDecoder>

#include <algorithm>
#include <array>
#include <optional>

namespace app::dxf {
namespace {

// Windows-1252 from 0x80 to 0x9f; elsewhere it is Latin-1.
constexpr std::array<char16_t, 32> western{
    0x20ac, 0x81,   0x201a, 0x192,  0x201e, 0x2026, 0x2020, 0x2021, 0x2c6,  0x2030, 0x160,
    0x2039, 0x152,  0x8d,   0x17d,  0x8f,   0x90,   0x2018, 0x2019, 0x201c, 0x201d, 0x2022,
    0x2013, 0x2014, 0x2dc,  0x2122, 0x161,  0x203a, 0x153,  0x9d,   0x17e,  0x178};

bool isAscii(std::string_view bytes)
{
    return std::ranges::all_of(bytes, [](char c) { return (std::uint8_t(c) & 0x80) == 0; });
}

std::optional<QString> asUtf8(std::string_view bytes)
{
    QStringDecoder decoder(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
    QString text = decoder.decode(QByteArrayView(bytes.data(), qsizetype(bytes.size())));
    return decoder.hasError() ? std::nullopt : std::optional(std::move(text));
}

QString asWestern(std::string_view bytes)
{
    QString text;
    for (const char c : bytes) {
        const std::uint8_t byte = std::uint8_t(c);
        text += byte >= 0x80 && byte < 0xa0 ? QChar(western[byte - 0x80U]) : QChar(ushort(byte));
    }
    return text;
}

// \U+XXXX as the character.
QString withCharacters(const QString& text)
{
    constexpr qsizetype size = 7;
    const QString mark = QStringLiteral("\\U+");
    QString result;
    qsizetype from = 0;
    for (qsizetype at = text.indexOf(mark); at >= 0; at = text.indexOf(mark, at + 1)) {
        bool isNumber = false;
        const ushort code = text.mid(at + mark.size(), 4).toUShort(&isNumber, 16);
        if (at < from || !isNumber || at + size > text.size())
            continue;
        result += text.mid(from, at - from) + QChar(code);
        from = at + size;
    }
    return from == 0 ? text : result + text.mid(from);
}

} // namespace

QString textOf(std::string_view bytes, const Header& header)
{
    if (isAscii(bytes))
        return withCharacters(QString::fromLatin1(bytes.data(), qsizetype(bytes.size())));
    if (header.utf8)
        return withCharacters(QString::fromUtf8(bytes.data(), qsizetype(bytes.size())));
    const auto utf8 = asUtf8(bytes); // LibreCAD writes it in older versions, too
    return withCharacters(utf8 ? *utf8 : asWestern(bytes));
}

bool isForeign(std::string_view bytes, const Header& header)
{
    const std::string page = inCapitals(header.codePage);
    return !isAscii(bytes) && !header.utf8 && !page.empty() && page != "ANSI_1252"
           && !asUtf8(bytes);
}

QString plainText(const QString& text)
{
    QString result;
    for (qsizetype i = 0; i < text.size(); ++i) {
        if (text[i] != u'%' || i + 2 >= text.size() || text[i + 1] != u'%') {
            result += text[i];
            continue;
        }
        bool isNumber = false;
        if (const ushort code = text.mid(i + 2, 3).toUShort(&isNumber);
            isNumber && i + 4 < text.size()) {
            result += QChar(code);
            i += 4;
            continue;
        }
        static constexpr std::array<std::pair<char16_t, char16_t>, 4> signs{
            {{u'd', u'°'}, {u'p', u'±'}, {u'c', u'Ø'}, {u'%', u'%'}}};
        const auto sign = std::ranges::find(signs, text[i + 2].toLower().unicode(),
                                            &std::pair<char16_t, char16_t>::first);
        if (sign != signs.end())
            result += QChar(sign->second);
        i += 2;
    }
    return result;
}

namespace {

/// Takes the formatting out of a text; a line for each paragraph.
class Unformatted {
public:
    explicit Unformatted(const QString& text) : text_(text) {}

    QStringList read()
    {
        while (at_ < text_.size())
            step();
        return std::move(lines_);
    }

private:
    void step()
    {
        const QChar c = text_[at_++];
        if (c == u'\\' && at_ < text_.size())
            code(text_[at_++]);
        else if (c == u'^' && at_ < text_.size())
            control(text_[at_++]);
        else if (c != u'{' && c != u'}')
            lines_.back() += c;
    }
    void control(QChar c)
    {
        if (c == u'J')
            lines_ << QString();
        else if (c == u'I' || c == u' ')
            lines_.back() += c == u'I' ? u' ' : u'^';
    }
    void code(QChar c)
    {
        if (c == u'P' || c == u'X' || c == u'N')
            lines_ << QString();
        else if (c == u'~')
            lines_.back() += u' ';
        else if (c == u'S')
            lines_.back() += argument().replace(u'#', u'/').replace(u'^', u'/');
        else if (QStringLiteral("ACcFfHQTWp").contains(c))
            argument();
        else if (!QStringLiteral("LlOoKk").contains(c))
            lines_.back() += c;
    }
    QString argument() // to the semicolon
    {
        const qsizetype end = text_.indexOf(u';', at_);
        if (end < 0)
            return {};
        const QString found = text_.mid(at_, end - at_);
        at_ = end + 1;
        return found;
    }

    const QString& text_;
    qsizetype at_ = 0;
    QStringList lines_{QString()};
};

} // namespace

QStringList paragraphs(const QString& text)
{
    QStringList lines = Unformatted(text).read();
    for (QString& line : lines)
        line = plainText(line);
    return lines;
}

} // namespace app::dxf

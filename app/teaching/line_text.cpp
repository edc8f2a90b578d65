// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/line_text.h"

#include <QLocale>
#include <QRegularExpression>

#include <array>

namespace app {

namespace {

bool commaIsDecimal() { return QLocale().decimalPoint() == QStringLiteral(","); }

QString separator() { return commaIsDecimal() ? QStringLiteral("; ") : QStringLiteral(", "); }

/// With the decimal mark of the locale, otherwise locale-independent, so that it reads back.
QString coordinateText(double value)
{
    QString text = QLocale::c().toString(value, 'g', QLocale::FloatingPointShortest);
    if (commaIsDecimal())
        text.replace(u'.', u',');
    return text.replace(u'-', u'\u2212');
}

/// The role of commas in a text: separators or decimal marks.
enum class Comma : std::uint8_t { Separates, IsDecimal };

std::optional<double> numberFrom(QString text, Comma comma)
{
    if (comma == Comma::IsDecimal)
        text.replace(u',', u'.');
    QLocale plain = QLocale::c();
    plain.setNumberOptions(QLocale::RejectGroupSeparator);
    bool read = false;
    const double value = plain.toDouble(text, &read);
    return read ? std::optional(value) : std::nullopt;
}

/// Number, separator, number; between the ends an arrow or "to" is allowed too.
QRegularExpression linePattern(const QString& number, const QString& separator)
{
    const QString end = number + separator + number;
    return QRegularExpression(
        QStringLiteral("^\\s*%1(?:\\s*(?:->|\u2192|to)\\s*|%2)%1\\s*$").arg(end, separator));
}

std::optional<clipping::Segment> lineFrom(const QString& plain, Comma comma)
{
    static const QRegularExpression commas =
        linePattern(QStringLiteral("([^\\s,;]+?)"), QStringLiteral("(?:\\s*[,;]\\s*|\\s+)"));
    static const QRegularExpression decimals =
        linePattern(QStringLiteral("([^\\s;]+?)"), QStringLiteral("(?:\\s*;\\s*|,?\\s+)"));
    const auto match = (comma == Comma::Separates ? commas : decimals).match(plain);
    std::array<double, 4> values{};
    for (int i = 0; i < 4; ++i) {
        const auto value = numberFrom(match.captured(i + 1), comma);
        if (!value)
            return std::nullopt;
        values[std::size_t(i)] = *value;
    }
    return clipping::Segment{{values[0], values[1]}, {values[2], values[3]}};
}

} // namespace

QString lineText(const clipping::Segment& line)
{
    const auto end = [](const glm::dvec2& p) {
        return coordinateText(p.x) + separator() + coordinateText(p.y);
    };
    return end(line.a) + QStringLiteral(" \u2192 ") + end(line.b);
}

QString pairText(const QString& x, const QString& y) { return u'(' + x + separator() + y + u')'; }

std::optional<clipping::Segment> lineFrom(const QString& text)
{
    static const QRegularExpression brackets(QStringLiteral("[()\\[\\]]"));
    QString plain = text;
    plain.replace(u'\u2212', u'-').replace(brackets, QStringLiteral(" "));
    if (commaIsDecimal())
        if (const auto line = lineFrom(plain, Comma::IsDecimal))
            return line;
    return lineFrom(plain, Comma::Separates);
}

} // namespace app

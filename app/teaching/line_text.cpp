// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/line_text.h"

#include <QLocale>
#include <QRegularExpression>
#include <QStringList>

#include <vector>

namespace app {

namespace {

bool commaIsDecimal() { return QLocale().decimalPoint() == QStringLiteral(","); }

QString separator() { return commaIsDecimal() ? QStringLiteral("; ") : QStringLiteral(", "); }

/// With the decimal mark of the locale; all else as everywhere, so that it can be read back.
QString number(double value)
{
    QString text = QLocale::c().toString(value, 'g', QLocale::FloatingPointShortest);
    if (commaIsDecimal())
        text.replace(u'.', u',');
    return text.replace(u'-', u'\u2212');
}

std::optional<double> numberFrom(QString text)
{
    if (commaIsDecimal())
        text.replace(u',', u'.');
    QLocale plain = QLocale::c();
    plain.setNumberOptions(QLocale::RejectGroupSeparator);
    bool read = false;
    const double value = plain.toDouble(text, &read);
    return read ? std::optional(value) : std::nullopt;
}

/// The parts of one end, or of both: by the clearest separator that there is, for a comma may be a
/// decimal mark.
QStringList parts(const QString& text)
{
    static const QRegularExpression semicolon(QStringLiteral("\\s*;\\s*")),
        space(QStringLiteral(",?\\s+")), comma(QStringLiteral(","));
    const QString inner = text.trimmed();
    for (const QRegularExpression& separator : {semicolon, space, comma})
        if (inner.contains(separator))
            return inner.split(separator, Qt::SkipEmptyParts);
    return {inner};
}

} // namespace

QString lineText(const clipping::Segment& line)
{
    const auto end = [](const glm::dvec2& p) { return number(p.x) + separator() + number(p.y); };
    return end(line.a) + QStringLiteral(" \u2192 ") + end(line.b);
}

QString pairText(const QString& x, const QString& y) { return u'(' + x + separator() + y + u')'; }

std::optional<clipping::Segment> lineFrom(const QString& text)
{
    static const QRegularExpression arrow(QStringLiteral("\\s*(?:->|\u2192)\\s*")),
        brackets(QStringLiteral("[()\\[\\]]"));
    QString plain = text;
    plain.replace(u'\u2212', u'-').replace(brackets, QStringLiteral(" "));
    QStringList numbers;
    for (const QString& end : plain.split(arrow))
        numbers += parts(end);
    std::vector<double> values;
    for (const QString& part : numbers)
        if (const auto value = numberFrom(part))
            values.push_back(*value);
    if (numbers.size() != 4 || values.size() != 4)
        return std::nullopt;
    return clipping::Segment{{values[0], values[1]}, {values[2], values[3]}};
}

} // namespace app

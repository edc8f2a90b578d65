// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/line_text.h"

#include "app/base/number.h"

#include <QLocale>
#include <QRegularExpression>
#include <QUrlQuery>

#include <array>
#include <cmath>

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

namespace {

using Numbers = std::array<double, 4>;

std::optional<Numbers> numbers(const QString& text)
{
    const QStringList words = text.split(u',');
    Numbers all{};
    if (words.size() != qsizetype(all.size()))
        return std::nullopt;
    for (std::size_t i = 0; i < all.size(); ++i) {
        const auto number = parseNumber(words[qsizetype(i)].trimmed().toStdString());
        if (!number)
            return std::nullopt;
        all[i] = *number;
    }
    return all;
}

/// Empty if a coordinate is not finite.
std::optional<QString> numbersText(const Point& p, const Point& q)
{
    QStringList all;
    for (const double number : {p.x, p.y, q.x, q.y}) {
        if (!std::isfinite(number))
            return std::nullopt;
        all << QString::number(number, 'g', QLocale::FloatingPointShortest).remove(u'+');
    }
    return all.join(u',');
}

} // namespace

std::optional<QString> traceLink(const TracedLine& tracedLine)
{
    const auto line = numbersText(tracedLine.line.a, tracedLine.line.b);
    const auto window = numbersText(tracedLine.window.min, tracedLine.window.max);
    if (!line || !window || !tracedLine.corners.empty())
        return std::nullopt;
    return QStringLiteral("clearcut:trace?a=%1&line=%2&w=%3")
        .arg(keyOf(tracedLine.variant), *line, *window);
}

std::optional<TracedLine> tracedLineOf(const QUrl& link)
{
    if (link.scheme() != QStringLiteral("clearcut") || link.path() != QStringLiteral("trace"))
        return std::nullopt;
    const QUrlQuery query(link);
    const auto value = [&query](const char* name) {
        return query.queryItemValue(QLatin1StringView(name), QUrl::FullyDecoded);
    };
    const auto variant = findVariant(value("a"));
    const auto line = numbers(value("line")), window = numbers(value("w"));
    if (!variant || !line || !window)
        return std::nullopt;
    return TracedLine{.variant = *variant,
                      .line = {{(*line)[0], (*line)[1]}, {(*line)[2], (*line)[3]}},
                      .window = {{(*window)[0], (*window)[1]}, {(*window)[2], (*window)[3]}},
                      .y = YAxis::Up,
                      .origin = titleOf(*variant)};
}

} // namespace app

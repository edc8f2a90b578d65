// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/trace_link.h"

#include "app/base/number.h"

#include <QLocale>
#include <QUrlQuery>

#include <array>
#include <cmath>

namespace app {

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
    if (!line || !window || tracedLine.variant.misprint || !tracedLine.corners.empty())
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/slide_panels.h"

#include "app/base/numbers.h"
#include "app/base/text.h"

#include <QFontDatabase>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace app {

namespace {

constexpr double headingHeight = 32;
constexpr double smallText = 0.9; // of the body font: 18 pixels, the smallest text on a slide

double paintHeading(QPainter& painter, const QRectF& area, const QString& text,
                    const FigureColours& colours)
{
    painter.setFont(bold(sized(slideFonts().body, smallText)));
    painter.setPen(colours.text);
    const QRectF line(area.left(), area.top(), area.width(), headingHeight - 6);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, text);
    painter.fillRect(QRectF(area.left(), line.bottom() + 2, area.width(), 1), colours.rule);
    return area.top() + headingHeight;
}

/// A line of code in rows that fit a width: wrapped at spaces, continued with more indent.
QStringList wrapped(const QString& line, const QFontMetricsF& metrics, double width)
{
    constexpr qsizetype further = 4;
    const auto indent =
        std::ranges::find_if(line, [](QChar c) { return c != u' '; }) - line.begin();
    QStringList rows;
    QString rest = line;
    while (metrics.horizontalAdvance(rest) > width) {
        const qsizetype least = rows.isEmpty() ? indent : indent + further;
        qsizetype end = rest.size();
        while (end > least + 1 && metrics.horizontalAdvance(rest.left(end)) > width)
            --end;
        if (const qsizetype blank = rest.lastIndexOf(u' ', end); blank > least)
            end = blank;
        rows << rest.left(end);
        rest = QString(indent + further, u' ') + rest.mid(end).trimmed();
    }
    return rows << rest;
}

double rowHeight(const QFont& font) { return std::ceil(1.3 * font.pixelSize()); }

/// The code as it is painted: the rows of each line.
struct CodeRows {
    QFont font;
    std::vector<QStringList> lines;
    double height(std::size_t first, std::size_t end) const
    {
        double rows = 0;
        for (std::size_t i = first; i < end; ++i)
            rows += double(lines[i].size());
        return rows * rowHeight(font);
    }
};

CodeRows codeRows(const QStringList& code, const QFont& font, double width)
{
    const QFontMetricsF metrics(font);
    CodeRows rows{font, {}};
    for (const QString& line : code)
        rows.lines.push_back(wrapped(line, metrics, width));
    return rows;
}

/// Chooses the largest font in which all the code fits without wrapping; otherwise the smallest, in
/// which some lines are wrapped and some may not be shown.
CodeRows fittingCode(const QStringList& code, double width, double height)
{
    constexpr int largest = 24, smallest = 20;
    QFont font = slideFonts().code;
    for (int size = largest; size > smallest; --size) {
        font.setPixelSize(size);
        CodeRows rows = codeRows(code, font, width);
        const bool whole =
            std::ranges::all_of(rows.lines, [](const QStringList& r) { return r.size() == 1; });
        if (whole && rows.height(0, rows.lines.size()) <= height)
            return rows;
    }
    font.setPixelSize(smallest);
    return codeRows(code, font, width);
}

/// The range of lines that is shown: the highlighted line and as many around it as there is room
/// for.
std::pair<std::size_t, std::size_t> linesShown(const CodeRows& rows, std::size_t highlight,
                                               double height)
{
    std::size_t first = std::min(highlight, rows.lines.size() - 1), end = first + 1;
    for (bool grown = true; grown;) {
        grown = false;
        if (end < rows.lines.size() && rows.height(first, end + 1) <= height)
            ++end, grown = true;
        if (first > 0 && rows.height(first - 1, end) <= height)
            --first, grown = true;
    }
    return {first, end};
}

/// The variables that are shown if there is no room for all: the changed ones, then the first.
std::vector<const Variable*> shown(const NarratedStep& narrated, std::size_t room)
{
    std::vector<const Variable*> all;
    for (const Variable& variable : narrated.variables)
        all.push_back(&variable);
    if (all.size() <= room)
        return all;
    auto chosen = all;
    std::stable_partition(chosen.begin(), chosen.end(),
                          [](const Variable* v) { return v->changed(); });
    chosen.resize(room);
    std::erase_if(all, [&](const Variable* v) { return std::ranges::count(chosen, v) == 0; });
    return all;
}

/// A value in a column: with fewer digits if not all fit.
QString fitting(const Variable& variable, double width, const QFont& font)
{
    const QString exact = valueText(variable);
    const bool fits = QFontMetricsF(font).horizontalAdvance(exact) <= width;
    return fits || variable.kind != clipping::ValueKind::Number ? exact : shortText(variable.value);
}

void paintVariable(QPainter& painter, const QRectF& row, const Variable& variable,
                   const FigureColours& colours)
{
    const QFont body = sized(slideFonts().body, smallText);
    QFont code = slideFonts().code;
    code.setPixelSize(body.pixelSize());
    if (variable.changed())
        painter.fillRect(row.adjusted(-6, 0, 6, 0), colours.tint);
    painter.setPen(colours.text);
    painter.setFont(code);
    const QRectF name(row.left(), row.top(), row.width() * 0.28, row.height());
    painter.drawText(name, Qt::AlignLeft | Qt::AlignVCenter, variable.name);
    const QFont valueFont = variable.changed() ? bold(body) : body;
    const QRectF value(name.right(), row.top(), row.width() * 0.38, row.height());
    painter.setFont(valueFont);
    painter.drawText(value, Qt::AlignRight | Qt::AlignVCenter,
                     fitting(variable, value.width(), valueFont));
    if (!variable.changed())
        return;
    Variable before = variable;
    before.value = variable.before.value_or(0);
    const QRectF earlier(value.right() + 12, row.top(), row.right() - value.right() - 12,
                         row.height());
    painter.setFont(body);
    painter.setPen(variable.before ? colours.muted : colours.highlight);
    painter.drawText(earlier, Qt::AlignLeft | Qt::AlignVCenter,
                     variable.before
                         ? Text::tr("was %1").arg(fitting(before, earlier.width() - 44, body))
                         : Text::tr("new"));
}

struct Operation {
    QString name;
    std::uint64_t clipping::OperationCounts::*count;
};

std::array<Operation, 4> panelOperations()
{
    using Counts = clipping::OperationCounts;
    return {{{Text::tr("comparisons"), &Counts::comparisons},
             {Text::tr("additions"), &Counts::additions},
             {Text::tr("multiplications"), &Counts::multiplications},
             {Text::tr("divisions"), &Counts::divisions}}};
}

} // namespace

SlideFonts slideFonts()
{
    SlideFonts fonts{QGuiApplication::font(), QFontDatabase::systemFont(QFontDatabase::FixedFont)};
    fonts.body.setPixelSize(20);
    fonts.code.setPixelSize(20);
    return fonts;
}

QFont sized(QFont font, double factor)
{
    font.setPixelSize(std::max(1, qRound(font.pixelSize() * factor)));
    return font;
}

QFont bold(QFont font)
{
    font.setWeight(QFont::DemiBold);
    return font;
}

double paintCode(QPainter& painter, const QRectF& area, const Narration& narration,
                 std::size_t step, const FigureColours& colours)
{
    const double top = paintHeading(painter, area, Text::tr("Pseudo-code"), colours);
    const double numbers =
        QFontMetricsF(slideFonts().code).horizontalAdvance(QStringLiteral("00")) + 16;
    const double height = area.bottom() - top;
    const CodeRows rows = fittingCode(narration.code, area.width() - numbers, height);
    const double row = rowHeight(rows.font);
    const int line = step < narration.steps.size() ? narration.steps[step].line : 0;
    const auto [first, end] = linesShown(rows, std::size_t(std::max(0, line - 1)), height);
    painter.setFont(rows.font);
    double y = top;
    for (std::size_t i = first; i < end; ++i) {
        const double high = row * double(rows.lines[i].size());
        const QRectF all(area.left(), y, area.width(), high);
        if (int(i) + 1 == line) {
            painter.fillRect(all.adjusted(-6, 0, 6, 0), colours.tint);
            painter.fillRect(QRectF(all.left() - 6, all.top(), 3, high), colours.highlight);
        }
        painter.setPen(colours.muted);
        painter.drawText(QRectF(all.left(), y, numbers - 12, row),
                         Qt::AlignRight | Qt::AlignVCenter, QString::number(i + 1));
        painter.setPen(colours.text);
        for (const QString& text : rows.lines[i]) {
            painter.drawText(QRectF(all.left() + numbers, y, all.width() - numbers, row),
                             Qt::AlignLeft | Qt::AlignVCenter, text);
            y += row;
        }
    }
    return y;
}

double paintVariables(QPainter& painter, const QRectF& area, const NarratedStep& narrated,
                      const FigureColours& colours)
{
    constexpr double row = 25;
    double top = paintHeading(painter, area, Text::tr("Variables"), colours);
    const auto room = std::size_t(std::max(0.0, (area.bottom() - top) / row));
    const std::size_t all = narrated.variables.size();
    const auto rows = shown(narrated, all <= room ? all : std::max<std::size_t>(room, 1) - 1);
    for (const Variable* variable : rows) {
        paintVariable(painter, {area.left(), top, area.width(), row}, *variable, colours);
        top += row;
    }
    if (rows.size() == all)
        return top;
    painter.setFont(sized(slideFonts().body, smallText));
    painter.setPen(colours.muted);
    painter.drawText(QRectF(area.left(), top, area.width(), row), Qt::AlignLeft | Qt::AlignVCenter,
                     Text::tr("and %1 more").arg(all - rows.size()));
    return top + row;
}

double paintOperations(QPainter& painter, const QRectF& area, const Narration& narration,
                       std::size_t step, const FigureColours& colours)
{
    const double top = paintHeading(painter, area, Text::tr("Operations so far"), colours);
    const QFont number = bold(sized(slideFonts().body, 1.2)),
                small = sized(slideFonts().body, smallText);
    const QFontMetricsF large(number), words(small);
    struct Cell {
        QString now, of, name;
        double width;
    };
    std::vector<Cell> cells;
    double used = 0;
    for (const auto& [name, count] : panelOperations()) {
        Cell cell{countText(narration.steps[step].cost.*count),
                  Text::tr("of %1").arg(countText(narration.steps.back().cost.*count)), name, 0};
        cell.width =
            std::max(words.horizontalAdvance(name),
                     large.horizontalAdvance(cell.now) + 5 + words.horizontalAdvance(cell.of));
        used += cell.width;
        cells.push_back(cell);
    }
    const double gap = std::max(8.0, (area.width() - used) / double(cells.size() - 1));
    const double baseline = top + large.ascent();
    double left = area.left();
    for (const Cell& cell : cells) {
        painter.setFont(number);
        painter.setPen(colours.text);
        painter.drawText(QPointF(left, baseline), cell.now);
        painter.setFont(small);
        painter.setPen(colours.muted);
        painter.drawText(QPointF(left + large.horizontalAdvance(cell.now) + 5, baseline), cell.of);
        painter.drawText(QPointF(left, baseline + words.height()), cell.name);
        left += cell.width + gap;
    }
    return baseline + words.height() + words.descent();
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/slide_panels.h"

#include "app/view/numbers.h"

#include <QCoreApplication>
#include <QFontDatabase>
#include <QFontMetricsF>
#include <QGuiApplication>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace app {

namespace {

QString tr(const char* text) { return QCoreApplication::translate("Slide", text); }

constexpr double headingHeight = 26;

double paintHeading(QPainter& painter, const QRectF& area, const QString& text,
                    const FigureColours& colours)
{
    painter.setFont(bold(sized(slideFonts().body, 0.92)));
    painter.setPen(colours.text);
    const QRectF line(area.left(), area.top(), area.width(), headingHeight - 6);
    painter.drawText(line, Qt::AlignLeft | Qt::AlignVCenter, text);
    painter.fillRect(QRectF(area.left(), line.bottom() + 2, area.width(), 1), colours.rule);
    return area.top() + headingHeight;
}

bool isTooWide(const QStringList& code, const QFont& font, double width)
{
    const QFontMetricsF metrics(font);
    return std::ranges::any_of(
        code, [&](const QString& line) { return metrics.horizontalAdvance(line) > width; });
}

double rowHeight(int pixelSize) { return std::ceil(1.3 * pixelSize); }

/// The largest font in which all the code fits, or one that can still be read. Where there are too
/// many lines only some are shown, so these do not make it the smallest.
QFont codeFont(const QStringList& code, double width, double height)
{
    constexpr int largest = 15, readable = 12, smallest = 10;
    QFont font = slideFonts().code;
    for (int size = largest; size >= smallest; --size) {
        font.setPixelSize(size);
        const bool tooHigh = size > readable && rowHeight(size) * double(code.size()) > height;
        if (!tooHigh && !isTooWide(code, font, width))
            break;
    }
    return font;
}

void paintCodeLine(QPainter& painter, const QRectF& row, double numbers, const QString& text,
                   const FigureColours& colours)
{
    const QRectF code = row.adjusted(numbers, 0, 0, 0);
    painter.setPen(colours.text);
    painter.drawText(code, Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetricsF(painter.font()).elidedText(text, Qt::ElideRight, code.width()));
}

/// Which variables are shown where there is no room for all: the changed ones, then the first.
std::vector<const Variable*> shown(const Moment& moment, std::size_t room)
{
    std::vector<const Variable*> all;
    for (const Variable& variable : moment.variables)
        all.push_back(&variable);
    if (all.size() <= room)
        return all;
    auto chosen = all;
    std::ranges::stable_partition(chosen, [](const Variable* v) { return v->changed(); });
    chosen.resize(room);
    std::erase_if(all, [&](const Variable* v) { return std::ranges::count(chosen, v) == 0; });
    return all;
}

/// A value in a column: fewer digits where not all of them fit.
QString fitting(const Variable& variable, double width, const QFont& font)
{
    const QString exact = valueText(variable);
    const bool fits = QFontMetricsF(font).horizontalAdvance(exact) <= width;
    return fits || variable.kind != clipping::ValueKind::Number ? exact : shortText(variable.value);
}

void paintVariable(QPainter& painter, const QRectF& row, const Variable& variable,
                   const FigureColours& colours)
{
    const QFont body = sized(slideFonts().body, 0.9);
    QFont code = slideFonts().code;
    code.setPixelSize(body.pixelSize());
    if (variable.changed())
        painter.fillRect(row.adjusted(-6, 0, 6, 0), colours.tint);
    painter.setPen(colours.text);
    painter.setFont(code);
    const QRectF name(row.left(), row.top(), row.width() * 0.28, row.height());
    painter.drawText(name, Qt::AlignLeft | Qt::AlignVCenter,
                     QFontMetricsF(code).elidedText(variable.name, Qt::ElideRight, name.width()));
    const QFont valueFont = variable.changed() ? bold(body) : body;
    const QRectF value(name.right(), row.top(), row.width() * 0.36, row.height());
    painter.setFont(valueFont);
    painter.drawText(value, Qt::AlignRight | Qt::AlignVCenter,
                     fitting(variable, value.width(), valueFont));
    if (!variable.changed())
        return;
    Variable before = variable;
    before.value = variable.before.value_or(0);
    const QRectF earlier(value.right() + 12, row.top(), row.right() - value.right() - 12,
                         row.height());
    painter.setFont(sized(body, 0.92));
    painter.setPen(variable.before ? colours.muted : colours.lit);
    painter.drawText(earlier, Qt::AlignLeft | Qt::AlignVCenter,
                     variable.before
                         ? tr("was %1").arg(fitting(before, earlier.width() - 30, body))
                         : tr("new"));
}

struct Operation {
    QString name;
    std::uint64_t clipping::OperationCounts::*count;
};

std::array<Operation, 4> operations()
{
    using Counts = clipping::OperationCounts;
    return {{{tr("comparisons"), &Counts::comparisons},
             {tr("+ and \u2212"), &Counts::additions},
             {tr("multiplications"), &Counts::multiplications},
             {tr("divisions"), &Counts::divisions}}};
}

} // namespace

SlideFonts slideFonts()
{
    SlideFonts fonts{QGuiApplication::font(), QFontDatabase::systemFont(QFontDatabase::FixedFont)};
    fonts.body.setPixelSize(15);
    fonts.code.setPixelSize(14);
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

double paintCode(QPainter& painter, const QRectF& area, const Walk& walk, std::size_t step,
                 const FigureColours& colours)
{
    constexpr double numbers = 34;
    const double top = paintHeading(painter, area, tr("Pseudo-code"), colours);
    const double height = area.bottom() - top;
    const QFont font = codeFont(walk.code, area.width() - numbers, height);
    const double row = rowHeight(font.pixelSize());
    const auto lines = int(walk.code.size());
    const int room = std::min(lines, int(height / row));
    const int lit = step < walk.moments.size() ? walk.moments[step].line - 1 : -1;
    const int first = std::clamp(lit - room / 2, 0, lines - room);
    for (int i = 0; i < room; ++i) {
        const QRectF line(area.left(), top + i * row, area.width(), row);
        if (first + i == lit) {
            painter.fillRect(line.adjusted(-6, 0, 6, 0), colours.tint);
            painter.fillRect(QRectF(line.left() - 6, line.top(), 3, row), colours.lit);
        }
        painter.setFont(font);
        painter.setPen(colours.muted);
        painter.drawText(QRectF(line.left(), line.top(), numbers - 10, row),
                         Qt::AlignRight | Qt::AlignVCenter, QString::number(first + i + 1));
        paintCodeLine(painter, line, numbers, walk.code[first + i], colours);
    }
    return top + room * row;
}

double paintVariables(QPainter& painter, const QRectF& area, const Moment& moment,
                      const FigureColours& colours)
{
    constexpr double row = 20;
    double top = paintHeading(painter, area, tr("Variables"), colours);
    const auto room = std::size_t(std::max(0.0, (area.bottom() - top) / row));
    const std::size_t all = moment.variables.size();
    const auto rows = shown(moment, all <= room ? all : std::max<std::size_t>(room, 1) - 1);
    for (const Variable* variable : rows) {
        paintVariable(painter, {area.left(), top, area.width(), row}, *variable, colours);
        top += row;
    }
    if (rows.size() == all)
        return top;
    painter.setFont(sized(slideFonts().body, 0.85));
    painter.setPen(colours.muted);
    painter.drawText(QRectF(area.left(), top, area.width(), row), Qt::AlignLeft | Qt::AlignVCenter,
                     tr("and %1 more").arg(all - rows.size()));
    return top + row;
}

double paintOperations(QPainter& painter, const QRectF& area, const Walk& walk, std::size_t step,
                       const FigureColours& colours)
{
    const double top = paintHeading(painter, area, tr("Operations so far"), colours);
    const double width = area.width() / 4;
    const QFont body = slideFonts().body;
    double left = area.left();
    for (const auto& [name, count] : operations()) {
        const QString now = countText(walk.moments[step].cost.*count);
        const QFont number = bold(sized(body, 1.4));
        painter.setFont(number);
        painter.setPen(colours.text);
        const double baseline = top + 26;
        painter.drawText(QPointF(left, baseline), now);
        painter.setFont(sized(body, 0.82));
        painter.setPen(colours.muted);
        painter.drawText(QPointF(left + QFontMetricsF(number).horizontalAdvance(now) + 5, baseline),
                         tr("of %1").arg(countText(walk.moments.back().cost.*count)));
        painter.drawText(QPointF(left, baseline + 18), name);
        left += width;
    }
    return top + 50;
}

} // namespace app

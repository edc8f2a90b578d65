// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/tabular.h"

#include <QAbstractItemModel>
#include <QClipboard>
#include <QGuiApplication>

#include <algorithm>

namespace ui {

namespace {

bool digitsDiffer(const QFontMetrics& metrics)
{
    const QString digits = QStringLiteral("123456789");
    return std::ranges::any_of(digits, [&, zero = metrics.horizontalAdvance(u'0')](QChar digit) {
        return metrics.horizontalAdvance(digit) != zero;
    });
}

int advance(const QFontMetrics& metrics, QChar c)
{
    return metrics.horizontalAdvance(c.isDigit() ? QChar(u'0') : c);
}

} // namespace

int tabularWidth(const QFontMetrics& metrics, const QString& text)
{
    if (!digitsDiffer(metrics))
        return metrics.horizontalAdvance(text);
    int width = 0;
    for (const QChar c : text)
        width += advance(metrics, c);
    return width;
}

void drawTabular(QPainter& painter, const QRect& rect, Qt::Alignment alignment, const QString& text)
{
    const QFontMetrics metrics = painter.fontMetrics();
    if (!digitsDiffer(metrics)) {
        painter.drawText(rect, int(alignment), text);
        return;
    }
    const int width = tabularWidth(metrics, text);
    int x = alignment & Qt::AlignRight     ? rect.right() + 1 - width
            : alignment & Qt::AlignHCenter ? rect.center().x() - width / 2
                                           : rect.left();
    const int y = rect.center().y() + (metrics.ascent() - metrics.descent()) / 2;
    for (const QChar c : text) {
        painter.drawText(x + (advance(metrics, c) - metrics.horizontalAdvance(c)) / 2, y, c);
        x += advance(metrics, c);
    }
}

void copyCells(const QAbstractItemModel& model, const QRect& area)
{
    QStringList lines;
    for (int row = area.top() - 1; row <= area.bottom(); ++row) {
        QStringList cells;
        for (int column = area.left(); column <= area.right(); ++column)
            cells << (row < area.top()
                          ? model.headerData(column, Qt::Horizontal).toString().replace(u'\n', u' ')
                          : model.index(row, column).data().toString());
        lines << cells.join(u'\t');
    }
    QGuiApplication::clipboard()->setText(lines.join(u'\n') + u'\n');
}

} // namespace ui

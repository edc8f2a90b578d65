// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/copy_cells.h"

#include <QAbstractItemModel>
#include <QClipboard>
#include <QGuiApplication>

namespace ui {

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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/keep_together.h"

#include <QAbstractTextDocumentLayout>
#include <QTextBlock>
#include <QTextCursor>
#include <QTextDocument>
#include <QTextTable>

#include <algorithm>

namespace app {
namespace {

constexpr int belongsProperty = QTextFormat::UserProperty + 2;

/// The page of a paragraph's first line.
int pageOf(const QTextBlock& block)
{
    const QTextDocument& document = *block.document();
    const QRectF area = document.documentLayout()->blockBoundingRect(block);
    return int((area.top() + 0.5) / document.pageSize().height());
}

int pageOf(const QTextTable& table, int row)
{
    return pageOf(table.cellAt(row, 0).firstCursorPosition().block());
}

/// Whether a row would be alone on a page: below the headings, or at the end.
bool isTorn(const QTextTable& table, int page)
{
    const int last = table.rows() - 1;
    return pageOf(table, 0) != page || pageOf(table, std::min(2, last)) != page
           || pageOf(table, std::max(last - 1, 0)) != pageOf(table, last);
}

bool isTorn(const QTextBlock& block)
{
    const QTextBlock next = block.next();
    if (!next.isValid())
        return false;
    const QTextTable* table = QTextCursor(next).currentTable();
    return table ? isTorn(*table, pageOf(block)) : pageOf(next) != pageOf(block);
}

} // namespace

void setBelongsToNext(QTextBlockFormat& format) { format.setProperty(belongsProperty, true); }

void keepTogether(QTextDocument& document)
{
    QTextBlock first; // of paragraphs that belong together, such as a heading and a table's title
    for (QTextBlock block = document.begin(); block.isValid(); block = block.next()) {
        if (!block.blockFormat().boolProperty(belongsProperty)) {
            first = {};
            continue;
        }
        if (!first.isValid())
            first = block;
        if (!isTorn(block))
            continue;
        QTextBlockFormat format = first.blockFormat();
        format.setPageBreakPolicy(QTextFormat::PageBreak_AlwaysBefore);
        QTextCursor(first).setBlockFormat(format);
    }
}

} // namespace app

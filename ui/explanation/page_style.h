// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/look.h"

#include <QStyledItemDelegate>

class QTextDocument;

namespace ui {

/// Styles a document read from Markdown like a book page: line height 1.4, space before headings,
/// code and tables on a background of their own, links in the look's colour.
void styleMarkdown(QTextDocument& document, const Look& look);

/// Paints a row of an AlgorithmModel in the list of pages: marker, abbreviation, name; the year is
/// in the tooltip.
class TitlePainter : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override;
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override;
};

} // namespace ui

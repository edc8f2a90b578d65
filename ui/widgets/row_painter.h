// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/look.h"
#include "ui/look/look_icon.h"

#include <QPainter>
#include <QStyledItemDelegate>

namespace ui {

/// What the rows of panel lists have in common: their height, an eye in front, an elided name.
class RowPainter : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override
    {
        return {160, space::rowHeight};
    }

protected:
    static QRect eye(const QRect& row)
    {
        return {row.left() + space::dockMargin, row.center().y() - 7, 16, 16};
    }
    static void drawEye(QPainter& painter, const QRect& row, bool visible)
    {
        icon(visible ? "eye" : "eye-closed").paint(&painter, eye(row));
    }
    /// Whether a press at a point is on an icon.
    static bool hits(const QRect& icon, const QPoint& at)
    {
        return icon.adjusted(-4, -4, 4, 4).contains(at);
    }
    /// A name is muted if its thing is hidden or missing.
    static void drawName(QPainter& painter, const QStyleOptionViewItem& option, const QRect& box,
                         const QString& name, bool muted, Qt::TextElideMode elide = Qt::ElideRight)
    {
        const Look& look = lookOf(option.palette);
        painter.setPen(muted ? look.muted : look.text);
        painter.setFont(option.font);
        painter.drawText(box, Qt::AlignVCenter,
                         option.fontMetrics.elidedText(name, elide, box.width()));
    }
};

} // namespace ui

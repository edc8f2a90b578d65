// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/look/look.h"
#include "ui/look/look_icon.h"

#include <QAbstractItemView>
#include <QKeyEvent>
#include <QListView>
#include <QPainter>
#include <QStyledItemDelegate>

namespace ui {

/// A list in a panel that takes only the keys that move in it. All others, such as the letters of
/// tools and Delete, go on to the main window, which passes them to the canvas.
class PanelList : public QListView {
    Q_OBJECT

protected:
    void keyPressEvent(QKeyEvent* event) override
    {
        switch (event->key()) {
        case Qt::Key_Up:
        case Qt::Key_Down:
        case Qt::Key_Left:
        case Qt::Key_Right:
        case Qt::Key_PageUp:
        case Qt::Key_PageDown:
        case Qt::Key_Home:
        case Qt::Key_End:
            QListView::keyPressEvent(event);
            return event->accept(); // at its end, too: the drawing would be moved
        default:
            event->ignore();
        }
    }
};

/// Keeps one row of a list selected at all times: a click beside the rows, or with Ctrl on the
/// selected row, does not clear the selection. To be called after the view has its model.
void keepChoice(QAbstractItemView& view);

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

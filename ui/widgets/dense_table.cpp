// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/dense_table.h"

#include "ui/look/focus_ring.h"
#include "ui/look/look.h"
#include "ui/widgets/tabular.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>

namespace ui {

namespace {

constexpr int gap = DenseTable::gap;

QRect textIn(const QRect& cell, bool first)
{
    return cell.adjusted(first ? space::dockMargin : gap, 0, -gap, 0);
}

class Header : public QHeaderView {
public:
    explicit Header(QWidget* parent) : QHeaderView(Qt::Horizontal, parent)
    {
        setSectionsClickable(true);
        setHighlightSections(false);
        setSortIndicatorShown(true);
        setMinimumSectionSize(24);
        setFont(captionFont(font()));
    }

    QSize sizeHint() const override
    {
        return {QHeaderView::sizeHint().width(), space::dockTitleHeight};
    }

protected:
    /// Includes room for the arrow, so that nothing jumps when it appears.
    QSize sectionSizeFromContents(int section) const override
    {
        if (!model()) // it may be destroyed before the table
            return {};
        const QString text = model()->headerData(section, Qt::Horizontal).toString();
        return {fontMetrics().horizontalAdvance(text + QStringLiteral(" ▴")) + 2 * gap
                    + (visualIndex(section) == 0 ? space::dockMargin - gap : 0),
                space::dockTitleHeight};
    }

    void paintSection(QPainter* painter, const QRect& rect, int section) const override
    {
        const Look& look = lookOf(palette());
        const bool sorts = isSortIndicatorShown() && section == sortIndicatorSection();
        const QString text = model()->headerData(section, Qt::Horizontal).toString();
        const int side =
            model()->headerData(section, Qt::Horizontal, Qt::TextAlignmentRole).toInt();
        const QRect place = textIn(rect, visualIndex(section) == 0);
        painter->fillRect(rect, look.panel);
        painter->fillRect(rect.left(), rect.bottom(), rect.width(), 1, look.rule);
        painter->setFont(font());
        painter->setPen(sorts ? look.text : look.muted);
        const QFontMetrics metrics(font());
        const QStringList ends =
            model()->headerData(section, Qt::Horizontal, DenseTable::EndsRole).toStringList();
        const QString shown =
            ends.isEmpty() ? metrics.elidedText(text, Qt::ElideRight, place.width()) : ends.front();
        painter->drawText(place, side, shown);
        if (!ends.isEmpty())
            painter->drawText(place, Qt::AlignRight | Qt::AlignVCenter, ends.back());
        if (sorts)
            paintArrow(*painter, metrics.boundingRect(place, side, shown).right() + 2, place);
    }

private:
    /// Paints the arrow in the gap after the text, which does not move.
    void paintArrow(QPainter& painter, int x, const QRect& place) const
    {
        const double up = sortIndicatorOrder() == Qt::AscendingOrder ? 1 : -1;
        const QPointF middle(x + 3.0, QRectF(place).center().y() + 0.5);
        painter.save();
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(Qt::NoPen);
        painter.setBrush(lookOf(palette()).text);
        painter.drawPolygon(QPolygonF{middle + QPointF(-2.5, 1.5 * up),
                                      middle + QPointF(2.5, 1.5 * up),
                                      middle + QPointF(0, -1.5 * up)});
        painter.restore();
    }
};

class Cells : public QStyledItemDelegate {
public:
    explicit Cells(const DenseTable& table, QObject* parent)
        : QStyledItemDelegate(parent), table_(table)
    {
    }

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        return {tabularWidth(QFontMetrics(option.font), index.data().toString()) + 2 * gap
                    + space::dockMargin - gap,
                space::denseRowHeight};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override
    {
        const Look& look = lookOf(option.palette);
        const bool first = table_.horizontalHeader()->visualIndex(index.column()) == 0;
        table_.paintGround(*painter, option, index);
        painter->setFont(option.font);
        painter->setPen(look.text);
        const QRect place = textIn(option.rect, first);
        const QString text =
            QFontMetrics(option.font)
                .elidedText(index.data().toString(), Qt::ElideRight, place.width());
        drawTabular(*painter, place, Qt::Alignment(index.data(Qt::TextAlignmentRole).toInt()),
                    text);
    }

private:
    const DenseTable& table_;
};

} // namespace

DenseTable::DenseTable(QWidget* parent) : QTableView(parent)
{
    setHorizontalHeader(new Header(this));
    setItemDelegate(new Cells(*this, this));
    setFont(captionFont(font()));
    setFrameShape(QFrame::NoFrame);
    setShowGrid(false);
    setWordWrap(false);
    horizontalHeader()->setResizeContentsPrecision(200); // rows to measure; the others are similar
    setSelectionBehavior(SelectRows);
    setSelectionMode(SingleSelection);
    setTabKeyNavigation(false);
    setVerticalScrollMode(ScrollPerItem);
    setHorizontalScrollMode(ScrollPerPixel);
    setMouseTracking(true);
    verticalHeader()->hide();
    verticalHeader()->setMinimumSectionSize(space::denseRowHeight);
    verticalHeader()->setDefaultSectionSize(space::denseRowHeight);
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    viewport()->setAutoFillBackground(false);
}

void DenseTable::paintGround(QPainter& painter, const QStyleOptionViewItem& option,
                             const QModelIndex& index) const
{
    const Look& look = lookOf(option.palette);
    const bool chosen = option.state & QStyle::State_Selected;
    const QRect r = option.rect;
    if (chosen || hovered_ == index.row())
        painter.fillRect(r, chosen ? look.tint : look.hover);
    if (chosen && horizontalHeader()->visualIndex(index.column()) == 0)
        painter.fillRect(r.left(), r.top(), 3, r.height(), look.selection);
    if (chosen && hasFocus()) {
        painter.fillRect(r.left(), r.top(), r.width(), 1, look.selection);
        painter.fillRect(r.left(), r.bottom(), r.width(), 1, look.selection);
    }
}

/// Columns are x, rows are y; empty: nothing.
QRect DenseTable::cellsToCopy() const
{
    const QAbstractItemModel* cells = model();
    const int columns = cells ? cells->columnCount() : 0;
    if (selectionMode() == NoSelection)
        return {0, 0, columns, cells ? cells->rowCount() : 0};
    const QItemSelection selection =
        selectionModel() ? selectionModel()->selection() : QItemSelection();
    if (selection.isEmpty())
        return {};
    return {QPoint(0, selection.front().top()), QPoint(columns - 1, selection.front().bottom())};
}

// While the table has the focus, Ctrl+C copies its rows, whatever is selected in the drawing.
bool DenseTable::event(QEvent* event)
{
    if (event->type() == QEvent::ShortcutOverride
        && static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy)
        && !cellsToCopy().isEmpty()) {
        event->accept();
        return true;
    }
    return QTableView::event(event);
}

void DenseTable::keyPressEvent(QKeyEvent* event)
{
    if (!event->matches(QKeySequence::Copy))
        return QTableView::keyPressEvent(event);
    if (const QRect area = cellsToCopy(); !area.isEmpty())
        copyCells(*model(), area);
}

void DenseTable::paintEvent(QPaintEvent* event)
{
    QTableView::paintEvent(event);
    if (hasFocus() && !(selectionModel() && selectionModel()->hasSelection()))
        paintFocusRing(*viewport());
}

bool DenseTable::viewportEvent(QEvent* event)
{
    if (event->type() == QEvent::MouseMove)
        hover(rowAt(static_cast<QMouseEvent*>(event)->position().toPoint().y()));
    if (event->type() == QEvent::Leave)
        hover(-1);
    return QTableView::viewportEvent(event);
}

void DenseTable::hover(int row)
{
    if (row == hovered_)
        return;
    hovered_ = row;
    viewport()->update();
}

} // namespace ui

#include "moc_dense_table.cpp"

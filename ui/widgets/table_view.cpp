// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/table_view.h"

#include "app/experiment/one_by_one.h"
#include "ui/look/focus_ring.h"
#include "ui/widgets/algorithm_marker.h"
#include "ui/widgets/tabular.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QScrollBar>
#include <QStyledItemDelegate>

namespace ui {

namespace {

constexpr int padding = 8, marker = 12, headerLine = 16;

/// Paints a cell: marker, text in tabular figures; a last row with sums is semi-bold under a rule.
class CellPainter : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    bool sumIsLast = false;

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override
    {
        const Look& look = lookOf(option.palette);
        const bool sum = isSum(index);
        if (option.state & QStyle::State_Selected)
            painter->fillRect(option.rect, look.tint);
        if (sum)
            painter->fillRect(option.rect.left(), option.rect.top(), option.rect.width(), 1,
                              look.rule);
        painter->setFont(sum ? semiBold(option.font) : option.font);
        painter->setPen(index.data(TableModel::FaultRole).toBool() ? look.differs : look.text);
        QRect box = option.rect.adjusted(padding, 0, -padding, 0);
        if (const auto who = index.data(TableModel::VariantRole).toStringList(); !who.isEmpty()) {
            paintMarker(*painter, option, who);
            box.setLeft(box.left() + marker + padding);
        }
        drawTabular(*painter, box, Qt::Alignment(index.data(Qt::TextAlignmentRole).toInt()),
                    index.data().toString());
    }

    QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override
    {
        const bool marked = index.data(TableModel::VariantRole).isValid();
        const QFontMetrics metrics(isSum(index) ? semiBold(option.font) : option.font);
        return {tabularWidth(metrics, index.data().toString()) + 2 * padding
                    + (marked ? marker + padding : 0),
                std::max(space::denseRowHeight, metrics.height() + 4)};
    }

private:
    bool isSum(const QModelIndex& index) const
    {
        return sumIsLast && index.row() + 1 == index.model()->rowCount();
    }
    static void paintMarker(QPainter& painter, const QStyleOptionViewItem& option,
                            const QStringList& who)
    {
        const auto* algorithm = app::timedAlgorithm(who[0]);
        const int top = option.rect.center().y() - marker / 2;
        const QRectF box(option.rect.left() + padding, top + 0.5, marker, marker);
        const auto form =
            who[1] == u"published" ? clipping::Form::Published : clipping::Form::Corrected;
        app::paintMarker(painter, box, {algorithm, form}, groundOf(option.palette));
    }
};

/// Paints headings in muted text, with an arrow at the sort column and a rule below.
class Headings : public QHeaderView {
public:
    explicit Headings(QWidget* parent) : QHeaderView(Qt::Horizontal, parent)
    {
        setSectionsClickable(true);
        setHighlightSections(false);
        setMinimumSectionSize(24);
    }

    QSize sectionSizeFromContents(int section) const override
    {
        const QStringList lines = textOf(section).split(u'\n');
        int width = 0;
        for (const QString& line : lines)
            width = std::max(width, fontMetrics().horizontalAdvance(line));
        return {width + 2 * padding + (isSortIndicatorShown() ? 8 : 0),
                int(linesOf()) * std::max(headerLine, fontMetrics().height()) + 6};
    }

protected:
    void paintSection(QPainter* painter, const QRect& rect, int section) const override
    {
        const Look& look = lookOf(palette());
        const bool sorts = isSortIndicatorShown() && sortIndicatorSection() == section;
        painter->fillRect(rect, palette().base());
        painter->fillRect(rect.left(), rect.bottom(), rect.width(), 1, look.rule);
        painter->setFont(font());
        painter->setPen(sorts ? look.text : look.muted);
        const auto alignment = Qt::Alignment(
            model()->headerData(section, Qt::Horizontal, Qt::TextAlignmentRole).toInt());
        QString text = textOf(section);
        if (sorts)
            text += sortIndicatorOrder() == Qt::AscendingOrder ? QStringLiteral(" ▴")
                                                               : QStringLiteral(" ▾");
        painter->drawText(rect.adjusted(padding, 2, -padding, -4), int(alignment), text);
    }

private:
    QString textOf(int section) const
    {
        return model()->headerData(section, Qt::Horizontal, Qt::DisplayRole).toString();
    }
    qsizetype linesOf() const
    {
        qsizetype most = 1;
        for (int section = 0; section < count(); ++section)
            most = std::max(most, textOf(section).count(u'\n') + 1);
        return most;
    }
};

} // namespace

TableView::TableView(QWidget* parent) : QTableView(parent)
{
    sorted_.setSourceModel(&model_);
    sorted_.setSortRole(TableModel::SortRole);
    setHorizontalHeader(new Headings(this));
    setItemDelegate(new CellPainter(this));
    setModel(&sorted_);
    setShowGrid(false);
    setFrameShape(QFrame::NoFrame);
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    setSelectionMode(QAbstractItemView::ContiguousSelection);
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    setTabKeyNavigation(false);
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
    setFont(captionFont(font()));
    horizontalHeader()->setFont(font());
}

void TableView::show(app::Table table, Rows rows)
{
    setAccessibleName(table.title);
    static_cast<CellPainter*>(itemDelegate())->sumIsLast = rows == Rows::SumIsLast;
    setSortingEnabled(false);
    sorted_.sort(-1);
    model_.show(std::move(table));
    if (rows == Rows::Sortable) {
        horizontalHeader()->setSortIndicator(-1, Qt::AscendingOrder);
        setSortingEnabled(true);
    }
    fit();
    QTableView::show();
}

void TableView::fit()
{
    resizeColumnsToContents();
    resizeRowsToContents();
    setMaximumWidth(horizontalHeader()->length());
    updateGeometry();
}

QSize TableView::sizeHint() const
{
    const int bar =
        horizontalScrollBar()->maximum() > 0 ? horizontalScrollBar()->sizeHint().height() : 0;
    return {horizontalHeader()->length(),
            horizontalHeader()->sizeHint().height() + verticalHeader()->length() + bar + 2};
}

QSize TableView::minimumSizeHint() const { return {200, sizeHint().height()}; }

/// Copies with headings; for a single cell just its text.
void TableView::copy() const
{
    const auto selection = selectionModel()->selection();
    const bool all = selection.isEmpty() || selection.front().indexes().size() < 2;
    const int rows = sorted_.rowCount(), columns = sorted_.columnCount();
    const QRect area = all ? QRect(0, 0, columns, rows)
                           : QRect(QPoint(selection.front().left(), selection.front().top()),
                                   QPoint(selection.front().right(), selection.front().bottom()));
    copyCells(sorted_, area);
}

void TableView::keyPressEvent(QKeyEvent* event)
{
    if (event->matches(QKeySequence::Copy))
        return copy();
    QTableView::keyPressEvent(event);
}

void TableView::changeEvent(QEvent* event)
{
    QTableView::changeEvent(event);
    if (event->type() == QEvent::StyleChange || event->type() == QEvent::FontChange)
        fit();
}

void TableView::paintEvent(QPaintEvent* event)
{
    QTableView::paintEvent(event);
    if (hasFocus())
        paintFocusRing(*viewport());
}

/// Vertical scrolling is left to the parent.
void TableView::wheelEvent(QWheelEvent* event)
{
    if (event->angleDelta().x() != 0)
        QTableView::wheelEvent(event);
    else
        event->ignore();
}

/// A horizontal scroll bar needs additional height.
void TableView::resizeEvent(QResizeEvent* event)
{
    QTableView::resizeEvent(event);
    updateGeometry();
}

} // namespace ui

#include "moc_table_view.cpp"

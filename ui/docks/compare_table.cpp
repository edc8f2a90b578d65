// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/compare_table.h"

#include "ui/docks/compare_cells.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/panel_list.h"
#include "ui/widgets/tabular.h"

#include <QEvent>
#include <QScopedValueRollback>

#include <array>

namespace ui {

namespace {

constexpr qint64 sortMilliseconds = 1000;
constexpr int sparklineWidth = 96, leastNameWidth = 112;

/// The columns to hide if space is short, first to last.
constexpr std::array dispensable{CompareModel::Visible, CompareModel::Spread,
                                 CompareModel::Sparkline};

} // namespace

CompareTable::CompareTable(app::Session& session, QWidget* parent)
    : DenseTable(parent), session_(session), widths_(std::size_t(model_.columnCount()))
{
    sorted_.setSourceModel(&model_);
    sorted_.setSortRole(CompareModel::OrderRole);
    sorted_.setDynamicSortFilter(false);
    setModel(&sorted_);
    keepChoice(*this);
    setItemDelegate(new CompareCells(model_, *this));
    setAccessibleName(Text::tr("Compare"));
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(ScrollPerPixel);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    setSortingEnabled(true);
    sortByColumn(CompareModel::Median, Qt::AscendingOrder);
    connect(horizontalHeader(), &QHeaderView::sortIndicatorChanged, this, &CompareTable::showOrder);
    connect(this, &QTableView::activated, this, &CompareTable::choose);
    connect(&session, &app::Session::displayChanged, this, &CompareTable::follow);
}

void CompareTable::showRows(std::span<const app::RaceRow> rows, std::size_t lines,
                            app::WindowNeeds needs)
{
    const bool begins = model_.rowCount() != int(rows.size());
    if (begins || lines != model_.lines())
        std::ranges::fill(widths_, 0);
    model_.show(rows, lines, needs);
    if (begins)
        follow();
    if (begins || sinceSorted_.elapsed() >= sortMilliseconds)
        sort();
    showOrder();
    fitColumns();
}

int CompareTable::heightFor(int rows) const
{
    return horizontalHeader()->sizeHint().height() + rows * space::rowHeight;
}

void CompareTable::currentChanged(const QModelIndex& current, const QModelIndex& previous)
{
    DenseTable::currentChanged(current, previous);
    if (!following_)
        choose(current);
}

void CompareTable::choose(const QModelIndex& index)
{
    if (!index.isValid())
        return;
    const app::Variant& chosen = model_.row(sorted_.mapToSource(index).row()).variant;
    session_.changeDisplay([&chosen](app::Display& display) { display.variant = chosen; });
}

void CompareTable::follow()
{
    const QScopedValueRollback quiet(following_, true);
    const int row = model_.rowOf(session_.variant());
    if (row < 0)
        return selectionModel()->clear();
    const QModelIndex index = sorted_.mapFromSource(model_.index(row, CompareModel::Name));
    selectionModel()->setCurrentIndex(index, QItemSelectionModel::ClearAndSelect
                                                 | QItemSelectionModel::Rows);
}

void CompareTable::sort()
{
    const QScopedValueRollback quiet(following_, true);
    const QHeaderView* header = horizontalHeader();
    sorted_.sort(header->sortIndicatorSection(), header->sortIndicatorOrder());
    sinceSorted_.start();
}

/// No sort arrow at a column of times that are not meaningful; the rows are then in the catalogue's
/// order.
void CompareTable::showOrder()
{
    QHeaderView* header = horizontalHeader();
    header->setSortIndicatorShown(model_.sortsBy(header->sortIndicatorSection()));
    header->viewport()->update();
}

int CompareTable::widthOf(int column) const
{
    const QFontMetrics metrics(font());
    int width = 0;
    for (int row = 0; row < model_.rowCount(); ++row)
        width = std::max(width, tabularWidth(metrics, model_.index(row, column).data().toString()));
    const QString title = model_.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
    const QFontMetrics heading(horizontalHeader()->font());
    return std::max(width, heading.horizontalAdvance(title) + 1) + 2 * gap;
}

/// The name column gets the width that the others leave.
void CompareTable::fitColumns()
{
    int left = viewport()->width();
    for (int column = CompareModel::Sparkline; column < model_.columnCount(); ++column) {
        if (column == CompareModel::Here && !model_.limits())
            continue;
        int& width = widths_[std::size_t(column)];
        width = std::max(width, column == CompareModel::Sparkline ? sparklineWidth + 2 * gap
                                                                  : widthOf(column));
        left -= width;
    }
    setColumnHidden(CompareModel::Here, !model_.limits());
    for (const int column : dispensable) {
        const bool crowded = left < leastNameWidth;
        setColumnHidden(column, crowded);
        if (crowded)
            left += widths_[std::size_t(column)];
    }
    for (int column = CompareModel::Sparkline; column < model_.columnCount(); ++column)
        if (!isColumnHidden(column))
            setColumnWidth(column, widths_[std::size_t(column)]);
    setColumnWidth(CompareModel::Name, std::max(left, leastNameWidth));
}

void CompareTable::resizeEvent(QResizeEvent* event)
{
    DenseTable::resizeEvent(event);
    const bool roomy = heightFor(model_.rowCount()) <= height();
    verticalHeader()->setDefaultSectionSize(roomy ? space::rowHeight : space::denseRowHeight);
    fitColumns();
}

void CompareTable::changeEvent(QEvent* event)
{
    DenseTable::changeEvent(event);
    if (event->type() == QEvent::FontChange || event->type() == QEvent::StyleChange)
        std::ranges::fill(widths_, 0);
}

} // namespace ui

#include "moc_compare_table.cpp"

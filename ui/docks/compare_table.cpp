// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/compare_table.h"

#include "ui/docks/compare_cells.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/panel_list.h"
#include "ui/widgets/tabular.h"

#include <QContextMenuEvent>
#include <QScopedValueRollback>

namespace ui {

namespace {

constexpr int laneWidth = 96, mostTitle = 120; // in logical pixels
constexpr int highRow = 27;
constexpr int usualDigits = 3, fewDigits = 2; // significant ones of times

} // namespace

CompareTable::CompareTable(app::Session& session, QWidget* parent)
    : DenseTable(parent), session_(session), cells_(new CompareCells(model_, *this)),
      widths_(std::size_t(model_.columnCount()))
{
    sorted_.setSourceModel(&model_);
    sorted_.setSortRole(CompareModel::OrderRole);
    sorted_.setDynamicSortFilter(false);
    setModel(&sorted_);
    keepChoice(*this);
    setItemDelegate(cells_);
    setAccessibleName(Text::tr("Compare"));
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollMode(ScrollPerPixel);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setSortIndicatorShown(false);
    setRows(Rows::High);
    connect(horizontalHeader(), &QHeaderView::sectionClicked, this, &CompareTable::sortBy);
    connect(this, &QTableView::activated, this, [this](const QModelIndex& at) { choose(at); });
    connect(this, &QTableView::clicked, this, [this](const QModelIndex& at) {
        if (at.column() == CompareModel::Filled || at.column() == CompareModel::Hollow)
            choose(at, at.column() == CompareModel::Filled ? clipping::Form::Corrected
                                                           : clipping::Form::Published);
    });
    connect(&session, &app::Session::displayChanged, this, &CompareTable::follow);
    connect(&session, &app::Session::loaded, this, [this] { sortOnce(-1); }); // other times
}

void CompareTable::showRows(std::span<const app::RaceRow> rows, std::size_t lines,
                            app::WindowNeeds needs, const QString& limiting)
{
    const int before = model_.rowCount();
    const bool formsBefore[] = {model_.shows(clipping::Form::Corrected),
                                model_.shows(clipping::Form::Published)};
    if (lines != model_.lines())
        std::ranges::fill(widths_, 0);
    {
        const QScopedValueRollback quiet(following_, true);
        model_.show(rows, lines, needs, limiting);
    }
    if (before != model_.rowCount() || formsBefore[0] != model_.shows(clipping::Form::Corrected)
        || formsBefore[1] != model_.shows(clipping::Form::Published)) {
        std::ranges::fill(widths_, 0);
        sortOnce(-1);
        follow();
        updateGeometry();
    }
    fitColumns();
}

int CompareTable::heightFor(int rows, Rows height) const
{
    return horizontalHeader()->sizeHint().height()
           + rows * (height == Rows::High ? highRow : space::denseRowHeight);
}

void CompareTable::setRows(Rows height)
{
    rows_ = height;
    verticalHeader()->setDefaultSectionSize(height == Rows::High ? highRow : space::denseRowHeight);
    updateGeometry();
}

QSize CompareTable::sizeHint() const
{
    return {DenseTable::sizeHint().width(), heightFor(model_.rowCount(), rows_)};
}

void CompareTable::currentChanged(const QModelIndex& current, const QModelIndex& previous)
{
    DenseTable::currentChanged(current, previous);
    if (!following_)
        choose(current);
}

/// Without a form: the one that is used now, if it takes part.
void CompareTable::choose(const QModelIndex& index, std::optional<clipping::Form> form)
{
    if (!index.isValid())
        return;
    const app::RacePair& pair = model_.pair(sorted_.mapToSource(index).row());
    const bool both =
        model_.shows(clipping::Form::Corrected) && model_.shows(clipping::Form::Published);
    const auto wish =
        form.value_or(both ? session_.display().variant.form : pair.ablest().row.variant.form);
    const app::Variant chosen{pair.algorithm, wish};
    session_.changeDisplay([&chosen](app::Display& display) { display.variant = chosen; });
}

void CompareTable::contextMenuEvent(QContextMenuEvent* event)
{
    const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
    const QModelIndex index = byKey ? currentIndex() : indexAt(event->pos());
    if (index.isValid())
        emit menuWanted(*model_.pair(sorted_.mapToSource(index).row()).algorithm,
                        byKey ? viewport()->mapToGlobal(visualRect(index).center())
                              : event->globalPos());
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

void CompareTable::sortBy(int column)
{
    sortOnce(column == sortedBy_ || !model_.sortsBy(column) ? -1 : column);
}

void CompareTable::sortByTime()
{
    const int column =
        model_.shows(clipping::Form::Corrected) ? CompareModel::Filled : CompareModel::Hollow;
    if (model_.sortsBy(column))
        sortOnce(column);
}

/// -1: the order of the catalogue.
void CompareTable::sortOnce(int column)
{
    const QScopedValueRollback quiet(following_, true);
    sorted_.sort(-1); // equal rows are in the catalogue's order
    if (column >= 0)
        sorted_.sort(column, CompareModel::orderOf(column));
    sortedBy_ = column;
    model_.setInListsOrder(column < 0);
    QHeaderView* header = horizontalHeader();
    header->setSortIndicator(std::max(column, 0), CompareModel::orderOf(column));
    header->setSortIndicatorShown(column >= 0);
    header->viewport()->update();
}

bool CompareTable::hides(int column) const
{
    return (column == CompareModel::Here && !model_.limits())
           || (column == CompareModel::Filled && !model_.shows(clipping::Form::Corrected))
           || (column == CompareModel::Hollow && !model_.shows(clipping::Form::Published));
}

int CompareTable::widthOf(int column) const
{
    if (column == CompareModel::Lane)
        return laneWidth + 2 * gap;
    const QFontMetrics metrics(column == CompareModel::Differ ? semiBold(font()) : font());
    int width = 0;
    for (int row = 0; row < model_.rowCount(); ++row)
        width = std::max(width, tabularWidth(metrics, model_.index(row, column).data().toString()));
    const QString title = model_.headerData(column, Qt::Horizontal, Qt::DisplayRole).toString();
    const QFontMetrics heading(horizontalHeader()->font());
    return std::max(width, std::min(heading.horizontalAdvance(title) + 1, mostTitle)) + 2 * gap;
}

/// The width that is left for names beside the other columns, with times of that precision.
int CompareTable::spread(bool lane, int digits)
{
    model_.setLaneShown(lane);
    model_.setDigits(digits);
    const bool usual = lane && digits == usualDigits;
    int left = viewport()->width();
    for (int column = CompareModel::Lane; column < model_.columnCount(); ++column)
        if (!hides(column) && (lane || column != CompareModel::Lane)) {
            int& width = widths_[std::size_t(column)];
            width = usual ? std::max(width, widthOf(column)) : widthOf(column);
            left -= width;
        }
    return left;
}

/// The column of names gets the width that the others leave. Without room the lane goes first, then
/// a digit.
void CompareTable::fitColumns()
{
    const int least = cells_->leastNameWidth();
    int left = spread(true, usualDigits);
    const bool lane = left >= least;
    if (!lane)
        left = spread(false, usualDigits);
    if (left < least)
        left = spread(false, fewDigits);
    for (int column = CompareModel::Lane; column < model_.columnCount(); ++column) {
        setColumnHidden(column, hides(column) || (!lane && column == CompareModel::Lane));
        if (!isColumnHidden(column))
            setColumnWidth(column, widths_[std::size_t(column)]);
    }
    setColumnWidth(CompareModel::Name, std::max(left, least));
}

void CompareTable::resizeEvent(QResizeEvent* event)
{
    DenseTable::resizeEvent(event);
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/compare_cells.h"

#include "app/base/text.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/widgets/algorithm_marker.h"
#include "ui/widgets/tabular.h"

#include <QPainter>
#include <QSortFilterProxyModel>

namespace ui {

namespace {

constexpr int markerSide = 12, markerRoom = 20, leastFullName = 60;
constexpr int tickSide = 14;
constexpr int laneMarker = 11; // side, in logical pixels
constexpr double together = 5; // nearer markers hide each other: the filled one is in front

} // namespace

CompareCells::CompareCells(const CompareModel& model, DenseTable& table)
    : QStyledItemDelegate(&table), model_(model), table_(table)
{
}

void CompareCells::paint(QPainter* painter, const QStyleOptionViewItem& option,
                         const QModelIndex& index) const
{
    const auto* sorted = qobject_cast<const QSortFilterProxyModel*>(index.model());
    const app::RacePair& pair = model_.pair(sorted->mapToSource(index).row());
    table_.paintGround(*painter, option, index);
    if (index.column() == CompareModel::Name)
        paintName(*painter, option, pair);
    else if (index.column() == CompareModel::Lane)
        paintLane(*painter, option, pair);
    else
        paintNumber(*painter, option, index, pair);
}

int CompareCells::abbreviationWidth() const
{
    const QFontMetrics metrics(semiBold(table_.font()));
    int width = 0;
    for (int row = 0; row < model_.rowCount(); ++row)
        width = std::max(
            width, metrics.horizontalAdvance(app::latin(model_.pair(row).algorithm->abbreviation)));
    return width + DenseTable::gap;
}

int CompareCells::leastNameWidth() const
{
    return space::dockMargin + markerRoom + abbreviationWidth();
}

void CompareCells::paintName(QPainter& painter, const QStyleOptionViewItem& option,
                             const app::RacePair& pair) const
{
    const Look& look = lookOf(option.palette);
    const QRect cell = option.rect.adjusted(space::dockMargin, 0, -DenseTable::gap, 0);
    app::paintMarker(painter, QRectF(cell.left(), cell.center().y() - 5.5, markerSide, markerSide),
                     pair.ablest().row.variant, groundOf(look));
    QRect text = cell.adjusted(markerRoom, 0, 0, 0);
    painter.setFont(semiBold(option.font));
    painter.setPen(look.text);
    painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter,
                     app::latin(pair.algorithm->abbreviation));
    text.setLeft(text.left() + abbreviationWidth());
    const QString whole = app::latin(pair.algorithm->name);
    const bool repeats = pair.algorithm->name == pair.algorithm->abbreviation;
    if (repeats || text.width() < leastFullName)
        return;
    const QFontMetrics metrics(option.font);
    const QString name =
        metrics.horizontalAdvance(whole) <= text.width() ? whole : app::briefName(*pair.algorithm);
    painter.setFont(option.font);
    painter.setPen(look.muted);
    painter.drawText(text, Qt::AlignLeft | Qt::AlignVCenter,
                     metrics.elidedText(name, Qt::ElideRight, text.width()));
}

void CompareCells::paintLane(QPainter& painter, const QStyleOptionViewItem& option,
                             const app::RacePair& pair) const
{
    if (!model_.timed() || model_.lane().most <= 0)
        return;
    const Look& look = lookOf(option.palette);
    const QRectF lane = QRectF(option.rect).adjusted(DenseTable::gap, 0, -DenseTable::gap, 0);
    const double y = lane.center().y();
    const auto x = [&](const app::FormResult& form) {
        return lane.left() + lane.width() * model_.lane().share(form.summary.median);
    };
    const auto mark = [&](const app::FormResult& form) {
        QRectF box(0, 0, laneMarker, laneMarker);
        box.moveCenter({x(form), y});
        app::paintMarker(painter, box, form.row.variant, groundOf(look));
    };
    painter.fillRect(QRectF(lane.left(), y - 1, lane.width(), 2), look.rule);
    painter.fillRect(QRectF(lane.left(), y - 1.5, x(pair.ablest()) - lane.left(), 3), look.control);
    if (!pair.corrected || !pair.published)
        return mark(pair.ablest());
    const bool behind = std::abs(x(*pair.corrected) - x(*pair.published)) <= together;
    mark(behind ? *pair.published : *pair.corrected);
    mark(behind ? *pair.corrected : *pair.published);
}

void CompareCells::paintNumber(QPainter& painter, const QStyleOptionViewItem& option,
                               const QModelIndex& index, const app::RacePair& pair) const
{
    const Look& look = lookOf(option.palette);
    const int column = index.column();
    const bool differs = column == CompareModel::Differ && pair.judged().row.differences.all() > 0;
    const bool limited = column == CompareModel::Here
                         && !app::limitText(pair.ablest().row.variant, model_.needs()).isEmpty();
    const bool quiet = limited || (column == CompareModel::Hollow && !pair.published)
                       || (column == CompareModel::Differ && !differs);
    painter.setFont(differs ? semiBold(option.font) : option.font);
    painter.setPen(differs                        ? look.differs
                   : quiet                        ? look.muted
                   : column == CompareModel::Here ? look.good
                                                  : look.text);
    const QString text = index.data().toString();
    const QRect place = option.rect.adjusted(0, 0, -DenseTable::gap, 0);
    drawTabular(painter, place, Qt::AlignRight | Qt::AlignVCenter, text);
    if (column != CompareModel::Here || limited)
        return;
    const int left = place.right() - tabularWidth(painter.fontMetrics(), text) - tickSide - 2;
    const QRect tick(left, place.center().y() - tickSide / 2, tickSide, tickSide);
    painter.drawPixmap(
        tick, tinted(icon("tick"), tick.size(), painter.device()->devicePixelRatioF(), look.good));
}

} // namespace ui

#include "moc_compare_cells.cpp"

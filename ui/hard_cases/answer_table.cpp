// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/hard_cases/answer_table.h"

#include "app/base/numbers.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/widgets/algorithm_marker.h"
#include "ui/widgets/panel_list.h"

#include <QPainter>

#include <algorithm>

namespace ui {

namespace {

constexpr int nameWidth = 162, verdictWidth = 238, errorWidth = 84, iconSize = 14;

class AnswerCells : public QStyledItemDelegate {
public:
    AnswerCells(const AnswerModel& model, DenseTable& table)
        : QStyledItemDelegate(&table), model_(model), table_(table)
    {
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override
    {
        const app::CaseAnswer& answer = model_.answers()[std::size_t(index.row())];
        const Look& look = lookOf(option.palette);
        table_.paintGround(*painter, option, index);
        QRect cell = option.rect.adjusted(DenseTable::gap, 0, -DenseTable::gap, 0);
        if (index.column() == AnswerModel::Name) {
            cell.setLeft(option.rect.left() + space::dockMargin);
            return paintVariantName(*painter, cell, option, answer.variant);
        }
        const bool wrong = !answer.good();
        if (index.column() == AnswerModel::Verdict) {
            const QRect place(cell.left(), cell.center().y() - iconSize / 2, iconSize, iconSize);
            painter->drawPixmap(place, tinted(icon(wrong ? "warning" : "tick"), place.size(),
                                              painter->device()->devicePixelRatioF(),
                                              wrong ? look.differs : look.good));
            cell.setLeft(place.right() + 7);
        }
        const bool loud = wrong && index.column() == AnswerModel::Verdict;
        painter->setFont(loud ? semiBold(option.font) : option.font);
        painter->setPen(loud ? look.differs : look.text);
        painter->drawText(cell, index.data(Qt::TextAlignmentRole).toInt(),
                          painter->fontMetrics().elidedText(index.data().toString(), Qt::ElideRight,
                                                            cell.width()));
    }

private:
    const AnswerModel& model_;
    DenseTable& table_;
};

QString ulpsText(double ulps)
{
    if (ulps > 0 && ulps < 0.01)
        return QStringLiteral("< %1").arg(app::shortText(0.01));
    return app::shortText(ulps, ulps < 1000 ? 3 : 2);
}

} // namespace

void AnswerModel::show(const app::HardCase& hard)
{
    beginResetModel();
    answers_ = app::answersTo(hard);
    endResetModel();
}

int AnswerModel::rows() const { return int(answers_.size()); }

int AnswerModel::columns() const { return Columns; }

QString AnswerModel::text(const app::CaseAnswer& answer, int column) const
{
    switch (column) {
    case Name:
        return app::nameOf(answer.variant);
    case Verdict:
        return app::answerText(answer);
    case Error: // measurable only if both the answer and the exact result are finite and visible
        return answer.visible && answer.ulps >= 0 && answer.ruling != app::Ruling::Shown
                       && answer.ruling != app::Ruling::Allowed
                       && answer.ruling != app::Ruling::NotANumber
                   ? ulpsText(answer.ulps)
                   : QString();
    default:
        return app::pieceText(answer.visible);
    }
}

QVariant AnswerModel::cell(int row, int column, int role) const
{
    const app::CaseAnswer& answer = answers_[std::size_t(row)];
    if (role == Qt::DisplayRole)
        return text(answer, column);
    if (role == Qt::ToolTipRole)
        return Text::tr("%1: %2\n%3")
            .arg(app::titleOf(answer.variant), app::answerText(answer),
                 app::pieceText(answer.visible));
    if (role == Qt::TextAlignmentRole)
        return sideOf(column == Error);
    return {};
}

QVariant AnswerModel::heading(int column, int role) const
{
    const QStringList names{Text::tr("algorithm"), Text::tr("verdict"), Text::tr("error, ulps"),
                            Text::tr("visible piece")};
    if (role == Qt::DisplayRole)
        return names[column];
    if (role == Qt::TextAlignmentRole)
        return sideOf(column == Error);
    if (role == Qt::ToolTipRole && column == Error)
        return Text::tr(
            "Error of the ends in ulps: units in the last place of the largest coordinate");
    return {};
}

AnswerTable::AnswerTable(QWidget* parent) : DenseTable(parent)
{
    setModel(&model_);
    keepChoice(*this);
    setItemDelegate(new AnswerCells(model_, *this));
    setAccessibleName(Text::tr("Result of each algorithm"));
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    horizontalHeader()->setSectionsClickable(false);
    horizontalHeader()->setSortIndicatorShown(false);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
}

void AnswerTable::show(const app::HardCase& hard, const app::Variant& first)
{
    model_.show(hard);
    setFixedHeight(horizontalHeader()->sizeHint().height()
                   + model_.rowCount() * space::denseRowHeight);
    const auto& all = model_.answers();
    const auto found = std::ranges::find(all, first, &app::CaseAnswer::variant);
    setCurrentIndex(model_.index(found == all.end() ? 0 : int(found - all.begin()), 0));
}

const app::CaseAnswer* AnswerTable::chosen() const
{
    return currentIndex().isValid() ? &model_.answers()[std::size_t(currentIndex().row())]
                                    : nullptr;
}

void AnswerTable::currentChanged(const QModelIndex& current, const QModelIndex& previous)
{
    DenseTable::currentChanged(current, previous);
    if (current.isValid())
        emit answerChosen();
}

void AnswerTable::resizeEvent(QResizeEvent* event)
{
    DenseTable::resizeEvent(event);
    const double part = std::clamp(viewport()->width() / 720.0, 0.7, 1.0);
    setColumnWidth(AnswerModel::Name, int(nameWidth * part));
    setColumnWidth(AnswerModel::Verdict, int(verdictWidth * part));
    setColumnWidth(AnswerModel::Error, int(errorWidth * part));
    setColumnWidth(
        AnswerModel::Piece,
        std::max(80, viewport()->width() - int((nameWidth + verdictWidth + errorWidth) * part)));
}

} // namespace ui

#include "moc_answer_table.cpp"

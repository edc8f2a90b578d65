// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/history_panel.h"

#include "ui/docks/algorithm_list.h"
#include "ui/look/look.h"
#include "ui/look/text.h"

#include <QPainter>
#include <QSignalBlocker>
#include <QStyledItemDelegate>
#include <QTimer>

namespace ui {

namespace {

class StepDelegate final : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override
    {
        return {120, space::rowHeight};
    }
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override
    {
        const Look& look = lookOf(option.palette);
        drawRowGround(*painter, option);
        QRect box = option.rect.adjusted(space::dockMargin, 0, -space::dockMargin, 0);
        painter->setPen(look.muted);
        if (index.data(HistoryModel::SavedRole).toBool()) {
            const QString saved = Text::tr("saved");
            painter->setFont(captionFont(option.font));
            painter->drawText(box, Qt::AlignRight | Qt::AlignVCenter, saved);
            box.setRight(box.right() - painter->fontMetrics().horizontalAdvance(saved) - 6);
        }
        painter->setFont(option.font);
        if (!index.data(HistoryModel::UndoneRole).toBool())
            painter->setPen(look.text);
        painter->drawText(
            box, Qt::AlignVCenter,
            option.fontMetrics.elidedText(index.data().toString(), Qt::ElideRight, box.width()));
    }
};

} // namespace

HistoryPanel::HistoryPanel(const app::History& history, QWidget* parent)
    : model_(new HistoryModel(history, this))
{
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Preferred);
    setParent(parent);
    setModel(model_);
    setItemDelegate(new StepDelegate(this));
    setUniformItemSizes(true);
    setFrameShape(QFrame::NoFrame);
    setAccessibleName(Text::tr("History"));
    setToolTip(Text::tr("Click a step to go back or forward to it"));
    setMinimumHeight(3 * space::rowHeight);
    connect(model_, &HistoryModel::dataChanged, this, &HistoryPanel::follow);
    follow();
}

QSize HistoryPanel::sizeHint() const
{
    constexpr int rows = 4;
    return {PanelList::sizeHint().width(), rows * space::rowHeight};
}

void HistoryPanel::follow()
{
    {
        const QSignalBlocker quiet(this); // what the history did is not wanted again
        setCurrentIndex(model_->now());
    }
    scrollTo(model_->now());
    emit titled(title());
}

void HistoryPanel::currentChanged(const QModelIndex& current, const QModelIndex& previous)
{
    QListView::currentChanged(current, previous);
    if (current.isValid() && current != model_->now()) {
        emit stepWanted(current.row());
        QTimer::singleShot(0, this, &HistoryPanel::follow); // it may have been refused
    }
}

} // namespace ui

#include "moc_history_panel.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/history_model.h"

#include "ui/look/text.h"

namespace ui {

HistoryModel::HistoryModel(const app::History& history, QObject* parent)
    : CheckedModel(parent), history_(history), rows_(history.count() + 1)
{
    connect(&history, &app::History::indexChanged, this, &HistoryModel::follow);
    connect(&history, &app::History::cleanIndexChanged, this, &HistoryModel::follow);
}

QVariant HistoryModel::cell(int row, int, int role) const
{
    switch (role) {
    case Qt::DisplayRole:
    case Qt::AccessibleTextRole:
        return row > 0                    ? history_.text(row - 1)
               : history_.forgotten() > 0 ? Text::tr("Oldest step that can be undone")
                                          : Text::tr("Start");
    case UndoneRole:
        return row > history_.index();
    case SavedRole:
        return history_.cleanIndex() == row;
    default:
        return {};
    }
}

void HistoryModel::follow()
{
    const int rows = history_.count() + 1;
    if (rows > rows_) {
        beginInsertRows({}, rows_, rows - 1);
        rows_ = rows;
        endInsertRows();
    } else if (rows < rows_) {
        beginRemoveRows({}, rows, rows_ - 1);
        rows_ = rows;
        endRemoveRows();
    }
    // A new step may have replaced undone ones, and forgetting the oldest shifts all.
    tellChanged();
}

} // namespace ui

#include "moc_history_model.cpp"

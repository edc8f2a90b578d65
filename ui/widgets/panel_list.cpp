// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/panel_list.h"

namespace ui {

// Queued: if the program clears the selection, the current row becomes invalid only after that.
void keepChoice(QAbstractItemView& view)
{
    QItemSelectionModel* chosen = view.selectionModel();
    const auto choose = [&view, chosen] {
        const auto whole = view.selectionBehavior() == QAbstractItemView::SelectRows
                               ? QItemSelectionModel::Rows
                               : QItemSelectionModel::NoUpdate;
        if (!chosen->hasSelection() && chosen->currentIndex().isValid())
            chosen->select(chosen->currentIndex(), QItemSelectionModel::Select | whole);
    };
    QObject::connect(chosen, &QItemSelectionModel::selectionChanged, &view, choose,
                     Qt::QueuedConnection);
}

} // namespace ui

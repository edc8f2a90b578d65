// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/keep_choice.h"

namespace ui {

// Queued: where the program itself takes the choice away, the current row goes after the selection.
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

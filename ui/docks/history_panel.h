// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/docks/history_model.h"
#include "ui/widgets/panel_list.h"

namespace ui {

/// The steps of the history. A click or an arrow key goes to the state after a step; undone steps
/// are muted, the saved state is marked.
class HistoryPanel : public PanelList {
    Q_OBJECT

public:
    explicit HistoryPanel(const app::History& history, QWidget* parent = nullptr);

    QSize sizeHint() const override; ///< a few rows: lists above get the rest

    QString title() const { return model_->now().data().toString(); } ///< the last step

signals:
    void titled(const QString& remark);
    void stepWanted(int index); ///< the number of steps that shall be done

protected:
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;

private:
    void follow();

    HistoryModel* model_;
};

} // namespace ui

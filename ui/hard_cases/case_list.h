// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/hard_cases/case_filter.h"

#include <QAbstractListModel>
#include <QListView>

namespace ui {

/// The hard cases that a filter lets through.
class CaseModel : public QAbstractListModel {
    Q_OBJECT

public:
    explicit CaseModel(QObject* parent = nullptr);

    void setFilter(const app::CaseFilter& filter);
    const app::HardCase& hardCase(int row) const { return *cases_[std::size_t(row)]; }
    /// Where a case is; an invalid index if it is not let through.
    QModelIndex indexOf(const app::HardCase& hard) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

private:
    std::vector<const app::HardCase*> cases_;
};

/// Pictures with their titles below, as many side by side as there is room for.
class CaseList : public QListView {
    Q_OBJECT

public:
    explicit CaseList(QWidget* parent = nullptr);

    void setFilter(const app::CaseFilter& filter); ///< keeps what is chosen, or takes the first
    void choose(const app::HardCase& hard);        ///< nothing, where it is not let through
    const app::HardCase* chosen() const;           ///< null: nothing is let through

signals:
    void caseChosen(const app::HardCase* hard);

protected:
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    CaseModel model_;
};

} // namespace ui

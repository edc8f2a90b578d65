// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/hard_cases/case_filter.h"

#include <QAbstractListModel>
#include <QListView>

namespace ui {

/// The hard cases that match a filter.
class CaseModel : public QAbstractListModel {
    Q_OBJECT

public:
    explicit CaseModel(QObject* parent = nullptr);

    void setFilter(const app::CaseFilter& filter);
    const app::HardCase& hardCase(int row) const { return *cases_[std::size_t(row)]; }
    /// The index of a case; invalid if it does not match the filter.
    QModelIndex indexOf(const app::HardCase& hard) const;

    int rowCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;

private:
    std::vector<const app::HardCase*> cases_;
};

/// The pictures of the hard cases with titles below, as many side by side as fit.
class CaseList : public QListView {
    Q_OBJECT

public:
    explicit CaseList(QWidget* parent = nullptr);

    /// Keeps the selection if it matches, else selects the first.
    void setFilter(const app::CaseFilter& filter);
    void choose(const app::HardCase& hard); ///< does nothing if the case does not match
    const app::HardCase* chosen() const;    ///< null: no case matches

signals:
    void caseChosen(const app::HardCase* hard);

protected:
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
    void resizeEvent(QResizeEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    CaseModel model_;
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/hard_cases/case_answer.h"
#include "ui/widgets/dense_table.h"

#include <QAbstractTableModel>

namespace ui {

/// The results of all variants, including known misprints, for one hard case.
class AnswerModel : public QAbstractTableModel {
    Q_OBJECT

public:
    enum Column { Name, Verdict, Error, Piece, Columns };
    using QAbstractTableModel::QAbstractTableModel;

    void show(const app::HardCase& hard);
    const std::vector<app::CaseAnswer>& answers() const { return answers_; }

    int rowCount(const QModelIndex& parent = {}) const override;
    int columnCount(const QModelIndex& parent = {}) const override;
    QVariant data(const QModelIndex& index, int role) const override;
    QVariant headerData(int section, Qt::Orientation orientation, int role) const override;

private:
    QString text(const app::CaseAnswer& answer, int column) const;

    std::vector<app::CaseAnswer> answers_;
};

/// The results as a table of full height: right ones with a tick, wrong ones in the colour of
/// differing lines, both also in words.
class AnswerTable : public DenseTable {
    Q_OBJECT

public:
    explicit AnswerTable(QWidget* parent = nullptr);

    /// Shows the results and selects the row of `first`.
    void show(const app::HardCase& hard, const app::Variant& first);
    const AnswerModel& answers() const { return model_; }
    const app::CaseAnswer* chosen() const; ///< null: none

signals:
    void answerChosen();

protected:
    void currentChanged(const QModelIndex& current, const QModelIndex& previous) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    AnswerModel model_;
};

} // namespace ui

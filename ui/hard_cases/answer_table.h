// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/hard_cases/case_answer.h"
#include "ui/widgets/checked_model.h"
#include "ui/widgets/dense_table.h"

namespace ui {

/// The results of all variants, including known misprints, for one hard case.
class AnswerModel : public CheckedModel {
    Q_OBJECT

public:
    enum Column { Name, Verdict, Error, Piece, Columns };
    using CheckedModel::CheckedModel;

    void show(const app::HardCase& hard);
    const std::vector<app::CaseAnswer>& answers() const { return answers_; }

protected:
    int rows() const override;
    int columns() const override;
    QVariant cell(int row, int column, int role) const override;
    QVariant heading(int column, int role) const override;

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

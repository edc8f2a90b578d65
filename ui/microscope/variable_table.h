// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/microscope/variable_model.h"
#include "ui/widgets/dense_table.h"

namespace ui {

/// The variables of a step as a table: those that the step changed are tinted, semi-bold, and
/// marked in words.
class VariableTable : public DenseTable {
    Q_OBJECT

public:
    explicit VariableTable(QWidget* parent = nullptr);

    void show(std::vector<app::Variable> variables);

protected:
    void resizeEvent(QResizeEvent* event) override;

private:
    void fitColumns();
    void showChanged();

    VariableModel model_;
};

} // namespace ui

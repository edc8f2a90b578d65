// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/narration.h"

#include <QWidget>

class QToolButton;

namespace ui {

class Heading;
class VariableTable;

/// The variables that the current step reads or writes under a heading, with a link to all of them.
class VariablesPanel : public QWidget {
    Q_OBJECT

public:
    explicit VariablesPanel(QWidget* parent = nullptr);

    void show(const app::TracedLine& tracedLine, const app::Narration& narration,
              std::size_t step); ///< nothing if the narration does not have the step
    VariableTable& table() { return *table_; }

    QSize sizeHint() const override; ///< for the variables of a step

private:
    void showTable();

    Heading* heading_;
    QToolButton* link_;
    VariableTable* table_;
    std::vector<app::Variable> ofStep_, all_;
    bool showsAll_ = false;
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/docks/difference_model.h"
#include "ui/widgets/dense_table.h"

#include <QLabel>
#include <QSpinBox>
#include <QTimer>

namespace ui {

class VariantBox;

/// A against B: the lines of which they leave different things, counted in a sentence and listed.
/// While it is seen these lines are coloured on the canvas, and nothing is computed otherwise. A
/// row that is chosen is inspected and shown.
class DifferencePanel : public QWidget {
    Q_OBJECT

public:
    explicit DifferencePanel(app::Session& session, QWidget* parent = nullptr);

    QString summary() const { return summary_->text(); }
    /// Chooses both.
    void compare(const app::Variant& a, const app::Variant& b);
    /// The next difference of the list, or an earlier one; round and round.
    void go(int rows);

    QSize sizeHint() const override;

signals:
    /// Enter: a line under the microscope.
    void lineWanted(std::size_t line);
    void placeWanted(const clipping::Window& place); ///< is to be seen

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void addChoosers();
    void addTable();
    app::Comparison wanted() const;
    void ask();
    void change();
    void setBoth(const app::Variant& a, const app::Variant& b);
    void swap();
    void follow();
    void paintSummary();
    void fitColumns();
    void showRow(int row);
    void choose(int row);

    app::Session& session_;
    DifferenceModel model_;
    VariantBox *a_, *b_;
    QSpinBox* ulps_;
    QLabel *tick_, *summary_, *explanation_;
    DenseTable* table_;
    std::optional<app::Comparison> fittedTo_; ///< whose texts the columns have room for
    QTimer soon_;                             ///< follow(), after the next frame
    bool following_ = false;
};

} // namespace ui

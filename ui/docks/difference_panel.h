// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/docks/difference_model.h"
#include "ui/widgets/dense_table.h"
#include "ui/widgets/look_label.h"

#include <QLabel>
#include <QSpinBox>
#include <QTimer>
#include <QToolButton>

namespace ui {

class IconSign;
class VariantBox;

/// Compares variants A and B: the lines that they clip differently, counted in a sentence and
/// listed. Computes only while it is visible, and then these lines are coloured on the canvas. A
/// selected row's line is inspected and brought into view.
class DifferencePanel : public QWidget {
    Q_OBJECT

public:
    explicit DifferencePanel(app::Session& session, QWidget* parent = nullptr);

    QString summary() const { return summary_->text(); }
    QString position() const { return position_->text(); } ///< "3 of 2,108", of the chosen line
    /// Sets both variants.
    void compare(const app::Variant& a, const app::Variant& b);
    /// Moves by so many rows in the list of differences; wraps around at its ends.
    void go(int rows);
    void fitColumnsAnew(); ///< to what is shown now

    QSize sizeHint() const override;

signals:
    /// Enter was pressed: asks for the line in the microscope.
    void lineWanted(std::size_t line);
    void placeWanted(const clipping::Window& place); ///< asks to bring it into view
    void entered(); ///< a choice was made in a list: the focus returns to the canvas

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

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
    void paintPosition();
    void fitColumns();
    void keepWhole();
    void showRow(int row);
    void choose(int row);

    app::Session& session_;
    DifferenceModel model_;
    VariantBox *a_, *b_;
    QSpinBox* ulps_;
    IconSign* tick_;
    LookLabel *summary_, *explanation_;
    QLabel* position_;
    QToolButton *previous_, *next_;
    DenseTable* table_;
    /// What is compared, where, and in which unit.
    struct Fitting {
        app::Comparison comparison;
        std::optional<std::size_t> window; ///< its number; empty: the page
        app::Unit unit;
        friend bool operator==(const Fitting&, const Fitting&) = default;
    };
    std::optional<Fitting> fittedTo_; ///< to whose texts the columns were fitted
    QTimer soon_; ///< follow(), after the next frame
    bool following_ = false;
};

} // namespace ui

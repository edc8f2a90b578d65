// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/docks/truth_model.h"
#include "ui/widgets/dense_table.h"

#include <QLabel>
#include <QStackedWidget>
#include <QTimer>

namespace ui {

class VariantBox;
class ErrorHistogram;
class Magnifier;
class Segments;

/// How exact an algorithm is on this drawing, against exact arithmetic: in a sentence, a histogram,
/// and the list of lines, worst first. While it is seen the lines are coloured on the canvas, and
/// nothing is computed otherwise. A row that is chosen is inspected and shown; a double click
/// magnifies its worse end.
class ExactnessPanel : public QWidget {
    Q_OBJECT

public:
    explicit ExactnessPanel(app::Session& session, QWidget* parent = nullptr);

    QString summary() const { return summary_->text(); }
    Magnifier& magnifier() { return *magnifier_; }
    bool magnifies() const { return pages_->currentIndex() == 1; }
    /// Shows an end of a line, magnified: 0 or 1.
    void magnify(std::size_t line, int end);

    QSize sizeHint() const override;

signals:
    void placeWanted(const clipping::Window& place); ///< is to be seen

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void changeEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void addChoosers();
    QWidget* listPage();
    QWidget* magnifierPage();
    app::LiveTruth::Question wanted() const;
    void ask();
    void follow();
    void paintSummary();
    void showRow(int row);
    void magnifyRow(int row);
    void showEnd();
    void leaveMagnifier();

    app::Session& session_;
    TruthModel model_;
    VariantBox* algorithm_;
    Segments *yardstick_, *end_, *lattice_;
    QLabel *summary_, *heading_, *magnified_;
    ErrorHistogram* histogram_;
    DenseTable* table_;
    Magnifier* magnifier_;
    QStackedWidget* pages_;
    QTimer soon_;          ///< follow(), after the next frame
    std::size_t line_ = 0; ///< under the magnifier
    bool following_ = false;
};

} // namespace ui

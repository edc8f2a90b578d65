// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/docks/exactness_model.h"
#include "ui/widgets/dense_table.h"
#include "ui/widgets/look_label.h"

#include <QStackedWidget>
#include <QTimer>

namespace ui {

class VariantBox;
class ErrorHistogram;
class Magnifier;
class Segments;

/// The exactness of an algorithm on this drawing, compared with exact arithmetic: a sentence, a
/// histogram, and a list of lines, worst first. Computes only while it is visible, and then the
/// lines are coloured on the canvas. A selected row's line is inspected and brought into view; a
/// double click magnifies its worse end.
class ExactnessPanel : public QWidget {
    Q_OBJECT

public:
    explicit ExactnessPanel(app::Session& session, QWidget* parent = nullptr);

    QString summary() const { return summary_->text(); }
    Magnifier& magnifier() { return *magnifier_; }
    bool magnifies() const { return pages_->currentIndex() == 1; }
    /// Shows an end of a line in the magnifier; `end` is 0 or 1.
    void magnify(std::size_t line, int end);

    QSize sizeHint() const override;

signals:
    void placeWanted(const clipping::Window& place); ///< asks to bring it into view
    void entered(); ///< a choice was made in a list: the focus returns to the canvas

protected:
    void showEvent(QShowEvent* event) override;
    void hideEvent(QHideEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    void addChoosers();
    QWidget* listPage();
    QWidget* magnifierPage();
    app::LiveExactness::Question wanted() const;
    void ask();
    void follow();
    void paintSummary();
    void showRow(int row);
    void magnifyRow(int row);
    void showEnd();
    void leaveMagnifier();

    app::Session& session_;
    ExactnessModel model_;
    VariantBox* algorithm_;
    Segments *errorUnit_, *end_, *lattice_;
    LookLabel* summary_;
    QLabel *heading_, *magnified_;
    ErrorHistogram* histogram_;
    DenseTable* table_;
    Magnifier* magnifier_;
    QStackedWidget* pages_;
    QTimer soon_;          ///< follow(), after the next frame
    std::size_t line_ = 0; ///< the line in the magnifier
    bool following_ = false;
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/background.h"
#include "app/comparison/agreement.h"
#include "app/session/session.h"
#include "ui/widgets/look_label.h"

#include <QPushButton>
#include <QRadioButton>
#include <QStackedLayout>
#include <QTimer>

#include <functional>

namespace ui {

class IconSign;

/// Selects the algorithm that clips and its form, and says whether all algorithms agree on this
/// drawing and clip window. The comparison runs when nothing has changed for a moment; on large
/// drawings only on request.
class AlgorithmPanel : public QWidget {
    Q_OBJECT

public:
    explicit AlgorithmPanel(app::Session& session, QWidget* parent = nullptr);

    /// Compares on another thread, and then calls `done`; not if anything changes before.
    void compare(std::function<void()> done = {});
    void finish() { comparing_.wait(); } ///< waits for the comparison
    // The algorithm in the heading of the section.
    QIcon sign() const;
    QString abbreviation() const;
    QString title() const; ///< "Skala, as published, for Star: concave, 10 edges"
    QString verdict() const { return verdict_->text(); }
    QString instead() const { return instead_->text(); }
    const std::vector<app::Disagreement>& disagreements() const { return disagreements_; }

signals:
    void titled(const QString& title);
    void aboutWanted(const clipping::Algorithm& algorithm); ///< asks for its page
    void menuWanted(const clipping::Algorithm& algorithm, const QPoint& place); ///< of a row

protected:
    void showEvent(QShowEvent* event) override;

private:
    void followWindow();
    void outdate();
    void follow();
    void followNeeds();
    void showVerdict();
    void paintVerdict();

    app::Session& session_;
    QRadioButton *corrected_, *published_;
    IconSign* tick_;
    LookLabel* verdict_;
    QLabel* instead_;        ///< what clips if the chosen algorithm cannot
    QStackedLayout* remark_; ///< whether all agree, or `instead_`
    QPushButton* ask_;
    QTimer idle_;
    std::optional<clipping::Window> window_{};
    std::vector<app::Disagreement> disagreements_;
    app::Background<std::vector<app::Disagreement>> comparing_;
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/hard_cases/case_filter.h"

#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>

namespace ui {

class CaseList;
class CaseView;
class MainWindow;

/// The zoo of hard cases: a gallery at the left, what is chosen there at the right. The editor
/// stays usable.
class ZooWindow : public QDialog {
    Q_OBJECT

public:
    explicit ZooWindow(MainWindow& window);

    void choose(const app::HardCase& hard); ///< whatever is searched for
    /// Those at which a variant fails; nothing, if it is none that can be chosen.
    void chooseFailing(const QString& variant);
    CaseList& list() { return *list_; }
    CaseView& view() { return *view_; }

protected:
    void hideEvent(QHideEvent* event) override;

private:
    QWidget* left();
    void filter();
    void openMicroscope(const app::HardCase& hard, const app::Variant& variant);
    void draw(const app::HardCase& hard, const app::Variant& variant);

    MainWindow& window_;
    QLineEdit* search_;
    QComboBox* choice_;
    QLabel* nothing_;
    CaseList* list_;
    CaseView* view_;
    std::vector<app::CaseChoice> choices_;
};

/// Shows the window that belongs to that one; there is one at most.
ZooWindow& showZoo(MainWindow& window);

} // namespace ui

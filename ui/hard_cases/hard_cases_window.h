// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/hard_cases/case_filter.h"
#include "app/session/session.h"

#include <QComboBox>
#include <QDialog>
#include <QLabel>
#include <QLineEdit>

namespace ui {

class CaseList;
class CaseView;
class Files;

/// The gallery of hard cases: their list at the left, the selected case at the right. Not modal:
/// the editor stays usable.
class HardCasesWindow : public QDialog {
    Q_OBJECT

public:
    /// Opens a case in the microscope of `session` or, by `files`, as its drawing, and brings the
    /// editor's `window` to the front.
    HardCasesWindow(app::Session& session, Files& files, QWidget& window);

    /// Clears the search and the filter if they hide the case.
    void choose(const app::HardCase& hard);
    /// Shows the cases that a variant gets wrong; does nothing if the variant is not in the filter
    /// list.
    void chooseFailing(const QString& variant);
    CaseList& list() { return *list_; }
    CaseView& view() { return *view_; }

signals:
    void editorWanted(); ///< in front, with its microscope

protected:
    void hideEvent(QHideEvent* event) override;

private:
    QWidget* left();
    void filter();
    void openMicroscope(const app::HardCase& hard, const app::Variant& variant);
    void draw(const app::HardCase& hard, const app::Variant& variant);

    app::Session& session_;
    Files& files_;
    QLineEdit* search_;
    QComboBox* choice_;
    QLabel* nothing_;
    CaseList* list_;
    CaseView* view_;
    std::vector<app::CaseChoice> choices_;
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/judge/verdict.h"

#include <QWidget>

#include <memory>

class QLabel;
class QPushButton;

namespace ui {

class LookLabel;
class TableView;
class TablesPage;

/// A verdict: one sentence, remarks, and tables. A wrong line can be opened in the microscope.
class VerdictView : public QWidget {
    Q_OBJECT

public:
    explicit VerdictView(QWidget* parent = nullptr);

    void show(const std::shared_ptr<const app::plug_in::Verdict>& verdict);
    const app::plug_in::Verdict* verdict() const { return verdict_.get(); }
    void copy() const; ///< copies the table that was clicked last

signals:
    void wanted(const app::plug_in::Finding& finding); ///< asks for the line in the microscope

private:
    void showSentence();
    void follow(TableView* findings);
    void want();

    std::shared_ptr<const app::plug_in::Verdict> verdict_;
    LookLabel* sign_;
    QLabel *sentence_, *remarks_;
    QPushButton* look_;
    TablesPage* tables_;
    TableView* findings_ = nullptr;
};

} // namespace ui

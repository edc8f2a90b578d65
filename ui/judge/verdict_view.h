// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/judge/verdict.h"

#include <QWidget>

#include <memory>

class QLabel;
class QPushButton;

namespace ui {

class TableView;
class TablesPage;

/// A verdict: one sentence, what else is to be said, and its tables. A line that is wrong can be
/// looked at.
class VerdictView : public QWidget {
    Q_OBJECT

public:
    explicit VerdictView(QWidget* parent = nullptr);

    void show(const std::shared_ptr<const app::plug_in::Verdict>& verdict);
    const app::plug_in::Verdict* verdict() const { return verdict_.get(); }
    void copy() const; ///< the table that was clicked last

signals:
    void wanted(const app::plug_in::Finding& finding); ///< under the microscope

protected:
    void changeEvent(QEvent* event) override;

private:
    void showSentence();
    void follow(TableView* findings);
    void want();

    std::shared_ptr<const app::plug_in::Verdict> verdict_;
    QLabel *sign_, *sentence_, *remarks_;
    QPushButton* look_;
    TablesPage* tables_;
    TableView* findings_ = nullptr;
};

} // namespace ui

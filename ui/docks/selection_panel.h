// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/selection_numbers.h"

#include <QLabel>
#include <QTimer>
#include <QToolButton>
#include <QWidget>

#include <vector>

namespace app {
struct Arrangement;
}

namespace ui {

class LengthField;
class ReferencePoint;

/// The selection in numbers, and what arranges it. With nothing selected everything stays in its
/// place, disabled. Each edit is one undo step.
class SelectionPanel : public QWidget {
    Q_OBJECT

public:
    explicit SelectionPanel(app::Session& session, QWidget* parent = nullptr);

signals:
    void entered(); ///< a number was entered: the focus returns to the canvas
    void refused(const QString& sentence);
    void taken(); ///< a field's value is valid again
    void titled(const QString& remark);

private:
    QLayout* makeNumbers();
    QLayout* makeButtons();
    QToolButton* makeButton(const app::Arrangement& how);
    void showEvent(QShowEvent* event) override;
    app::SelectionFrame frame() const;
    void follow();
    void edit(const app::SelectionNumber& number, double value, app::Merging merging);

    app::Session& session_;
    std::vector<LengthField*> fields_; ///< in the order of app::selectionNumbers()
    ReferencePoint* reference_;
    QToolButton* chain_; ///< checked: W and H keep their ratio
    std::vector<QWidget*> needSelection_;
    std::vector<std::pair<QToolButton*, std::size_t>> buttons_; ///< with the least selection
    QTimer soon_; ///< merges several changes in one event into one update
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/selection_numbers.h"

#include <QCheckBox>
#include <QLabel>
#include <QStackedLayout>
#include <QTimer>
#include <QToolButton>
#include <QWidget>

#include <vector>

namespace app {
struct Arrangement;
}

namespace ui {

class LengthField;
class NodeFields;
class ReferencePoint;
class ToolList;

/// The selection in numbers, and what arranges it. With nothing selected everything stays in its
/// place, disabled. While nodes are selected, it shows their numbers instead, at the same height.
/// Each edit is one undo step.
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
    QWidget* makeObjects();
    QLayout* makeNumbers();
    std::pair<QLabel*, LengthField*> makeField(const app::SelectionNumber& number);
    QLayout* makeButtons();
    void makeOptions();
    QToolButton* makeButton(const app::Arrangement& how);
    void showEvent(QShowEvent* event) override;
    app::SelectionFrame frame() const;
    void follow();
    void followObjects();
    void followArranging();
    void edit(const app::SelectionNumber& number, double value, app::Merging merging);

    app::Session& session_;
    std::vector<LengthField*> fields_; ///< in the order of app::selectionNumbers()
    ReferencePoint* reference_;
    QToolButton* chain_; ///< checked: W and H keep their ratio
    ToolList* target_;   ///< what objects are aligned to
    QCheckBox* strokes_; ///< checked: widths of strokes are scaled
    NodeFields* nodes_;
    QStackedLayout* pages_; ///< objects, nodes
    std::vector<QWidget*> needSelection_;
    std::vector<std::pair<QToolButton*, const app::Arrangement*>> buttons_;
    QTimer soon_; ///< merges several changes in one event into one update
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/selection_numbers.h"

#include <QLabel>
#include <QStackedLayout>
#include <QTimer>
#include <QToolButton>
#include <QWidget>

#include <vector>

namespace ui {

class LengthField;
class NodeFields;
class ReferencePoint;

/// The selection in numbers. While nodes are selected, it shows their numbers instead, at the same
/// height. Each edit is one undo step.
class SelectionPanel : public QWidget {
    Q_OBJECT

public:
    explicit SelectionPanel(app::Session& session, QWidget* parent = nullptr);

signals:
    void entered(); ///< a number was entered: the focus returns to the canvas
    void refused(const QString& sentence);
    void taken(); ///< a field's value is valid again

private:
    QWidget* makeObjects();
    QLayout* makeNumbers();
    std::pair<QLabel*, LengthField*> makeField(const app::SelectionNumber& number);
    void showEvent(QShowEvent* event) override;
    app::SelectionFrame frame() const;
    void follow();
    void followObjects();
    void edit(const app::SelectionNumber& number, double value, app::Merging merging);

    app::Session& session_;
    std::vector<LengthField*> fields_; ///< in the order of app::selectionNumbers()
    ReferencePoint* reference_;
    QToolButton* chain_; ///< checked: W and H keep their ratio
    NodeFields* nodes_;
    enum Page { Objects, Nodes };
    QStackedLayout* pages_;
    QTimer soon_; ///< merges several changes in one event into one update
};

} // namespace ui

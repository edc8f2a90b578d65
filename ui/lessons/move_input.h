// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/practice/practice.h"

#include <QPushButton>
#include <QVBoxLayout>

class QLineEdit;
class QSlider;
class QSpinBox;

namespace ui {

/// Where a move is answered by keys: buttons for bits, edges and decisions, a slider for a place,
/// a field for a line of the pseudo-code or a value. What it shows is the practice's draft, which
/// the figure changes, too.
class MoveInput : public QWidget {
    Q_OBJECT

public:
    explicit MoveInput(app::Practice& practice, QWidget* parent = nullptr);

    void showMove();        ///< the current move, as far as it is answered
    QWidget* first() const; ///< what takes the focus; null: nothing
    bool isChecked() const; ///< by the button Check, and not answered by a press
    void check();           ///< answers with what is set; a value that is no number is refused
    QList<QPushButton*> buttons() const { return buttons_; }

signals:
    void refused(const QString& sentence);

private:
    void showBits(const app::Move& move);
    void showChoices(const QStringList& choices, int firstAnswer);
    void showEdges(const app::Move& move);
    void showDecisions(const app::Move& move);
    void showPlace(const app::Move& move);
    void showLine(const app::Move& move);
    void showValue(const app::Move& move);
    void showDraft();
    void add(QWidget* widget);

    app::Practice& practice_;
    QVBoxLayout* column_;
    QList<QPushButton*> buttons_;
    QSlider* slider_ = nullptr;
    QSpinBox* line_ = nullptr;
    QLineEdit* value_ = nullptr;
};

} // namespace ui

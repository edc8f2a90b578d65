// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QToolButton>

namespace ui {

/// The chevron in the heading of a section that folds. Space and Enter fold or unfold it, Left
/// folds, Right unfolds.
class FoldButton : public QToolButton {
    Q_OBJECT

public:
    FoldButton();

    void show(bool folded, const QString& section);
    using QToolButton::show;
    void press() { emit foldWanted(!folded_); }

signals:
    void foldWanted(bool folded);

protected:
    void keyPressEvent(QKeyEvent* event) override;

private:
    bool folded_ = false;
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QTextEdit>

namespace ui {

/// The pseudo-code of an algorithm with its line numbers; the step's line is highlighted and
/// scrolled into view.
class CodeView : public QTextEdit {
    Q_OBJECT

public:
    explicit CodeView(QWidget* parent = nullptr);

    void show(const QStringList& code);
    void light(int line); ///< highlights a line, counted from 1; 0: none
    int currentLine() const { return currentLine_; }

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    class Numbers;
    void paintNumbers();
    void placeNumbers();
    int numbersWidth() const;
    void keepInSight(); ///< the current line, also when there is another code or size
    QRectF rowOf(int line) const; ///< in viewport coordinates

    Numbers* numbers_ = nullptr;
    QStringList code_;
    int currentLine_ = 0;
};

} // namespace ui

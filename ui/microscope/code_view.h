// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/code_rows.h"

#include <QTextBlockFormat>
#include <QTextEdit>

namespace ui {

/// The pseudo-code of an algorithm with its line numbers; the step's line is highlighted and
/// scrolled into view. Branches that were not taken are folded; a click unfolds one, Enter all.
class CodeView : public QTextEdit {
    Q_OBJECT

public:
    explicit CodeView(QWidget* parent = nullptr);

    void show(const QStringList& code, const std::set<int>& run); ///< the lines that were run
    void light(int line); ///< highlights a line, counted from 1; 0: none
    int currentLine() const { return currentLine_; }
    const std::vector<app::CodeRow>& rows() const { return rows_; }

signals:
    void lineClicked(int line); ///< with the left button, where no branch folds

protected:
    bool viewportEvent(QEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void showEvent(QShowEvent* event) override;
    void changeEvent(QEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;

private:
    class Numbers;
    void fold();
    QTextBlockFormat blockOf(const QString& text) const;
    void showRows();
    void toggle(int row);
    void toggleAll();
    int rowAt(const QPoint& place) const; ///< that folds; -1: none
    void paintNumbers();
    void placeNumbers();
    int numbersWidth() const;
    void keepInSight();           ///< the current line, also when there is another code or size
    QRectF rowOf(int line) const; ///< in viewport coordinates
    QRectF boxOf(int row) const;

    Numbers* numbers_ = nullptr;
    QStringList code_;
    std::set<int> run_, unfolded_; ///< lines
    std::vector<app::CodeRow> rows_;
    int currentLine_ = 0;
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QLineEdit>

class QLabel;

namespace ui {

/// A field that narrows what is listed below it, with the number of what is found at its right. Esc
/// clears it; when it is empty, Esc is the window's.
class SearchField : public QLineEdit {
    Q_OBJECT

public:
    explicit SearchField(const QString& what, QWidget* parent = nullptr);

    void showResult(const QString& count); ///< empty: nothing is typed

signals:
    void left(); ///< Down or Enter: to what is found

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void place();

    QLabel* result_;
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QHBoxLayout;
class QLabel;
class QProgressBar;
class QPushButton;

namespace ui {

/// The row at the bottom of a window that works in the background: a sentence, and during the work
/// a progress bar and the button Cancel. They keep their places, so that nothing moves.
class ProgressRow : public QWidget {
    Q_OBJECT

public:
    explicit ProgressRow(QWidget* parent = nullptr);

    void tell(const QString& sentence);
    QString sentence() const;
    /// The bar is empty, and the sentence says that the work starts.
    void start();
    void showProgress(double share, const QString& sentence); ///< share: 0 to 1
    void setWorking(bool working);                            ///< initially false
    void addButton(QPushButton* button);                      ///< at the end of the row

signals:
    void cancelWanted();

private:
    QLabel* sentence_;
    QProgressBar* bar_;
    QPushButton* cancel_;
    QHBoxLayout* row_;
};

} // namespace ui

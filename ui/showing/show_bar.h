// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFrame>

class QLabel;

namespace ui {

class ElidedLabel;

/// Which step of a page is shown, at the lower edge of its first parent, with *Next step* and
/// *Stop*.
class ShowBar : public QFrame {
    Q_OBJECT

public:
    explicit ShowBar(QWidget* parent = nullptr);

    /// `number` counts from 1.
    void say(int number, int all, const QString& what);

signals:
    void nextWanted();
    void stopWanted();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

private:
    void place();

    QLabel* number_;
    ElidedLabel* what_;
};

} // namespace ui

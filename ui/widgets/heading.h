// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QHBoxLayout;
class QLabel;

namespace ui {

/// The title of a part of a page, in the style of dock titles; a muted remark may follow it, and a
/// link may be at its right.
class Heading : public QWidget {
    Q_OBJECT

public:
    explicit Heading(const QString& title, QWidget* parent = nullptr);
    void setRemark(const QString& remark);
    void add(QWidget* widget);

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QHBoxLayout* row_;
    QLabel* remark_;
};

} // namespace ui

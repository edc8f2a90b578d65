// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QWidget>

class QHBoxLayout;

namespace ui {

/// The title of a part of the microscope, in the style of dock titles; a link may be at its right.
class Heading : public QWidget {
    Q_OBJECT

public:
    explicit Heading(const QString& title, QWidget* parent = nullptr);
    void add(QWidget* widget);

    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QHBoxLayout* row_;
};

} // namespace ui

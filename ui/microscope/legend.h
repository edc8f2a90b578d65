// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/walk.h"

#include <QWidget>

namespace ui {

/// What the signs of the timeline mean: those that there are in a walk.
class Legend : public QWidget {
    Q_OBJECT

public:
    explicit Legend(QWidget* parent = nullptr);

    void show(const app::Walk& walk);
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::vector<app::Mark> marks_;
};

} // namespace ui

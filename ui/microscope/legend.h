// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/narration.h"

#include <QWidget>

namespace ui {

/// A legend of the timeline's marks; shows only the marks that occur in the trace.
class Legend : public QWidget {
    Q_OBJECT

public:
    explicit Legend(QWidget* parent = nullptr);

    void show(const app::Narration& narration);
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    std::vector<app::Mark> marks_;
};

} // namespace ui

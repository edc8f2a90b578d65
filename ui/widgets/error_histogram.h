// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exactness/error_class.h"

#include <QWidget>

namespace ui {

/// The number of lines in each error class: one bar per class, in the colour of its lines on the
/// canvas, so that the histogram is also their legend.
class ErrorHistogram : public QWidget {
    Q_OBJECT

public:
    explicit ErrorHistogram(QWidget* parent = nullptr);

    void show(const app::ErrorCounts& counts);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    app::ErrorCounts counts_;
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/exactness/error_class.h"

#include <QWidget>

namespace ui {

/// How many lines there are of each class of error: a bar a class, in the colour that its lines
/// have on the canvas, so that it is their legend too.
class ErrorHistogram : public QWidget {
    Q_OBJECT

public:
    explicit ErrorHistogram(QWidget* parent = nullptr);

    void show(const app::TruthCounts& counts);

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override { return sizeHint(); }

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    app::TruthCounts counts_;
};

} // namespace ui

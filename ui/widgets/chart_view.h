// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart.h"
#include "app/view/chart_look.h"

#include <QWidget>

namespace ui {

/// What charts in this widget are painted with: its palette and its font.
app::ChartLook chartLookOf(const QWidget& widget);

/// Shows a chart. A row under the pointer, or chosen with the arrow keys, tells all that is known
/// of it. In less than its natural height it squeezes its rows.
class ChartView : public QWidget {
    Q_OBJECT

public:
    explicit ChartView(QWidget* parent = nullptr);

    void setChart(app::Chart chart);
    const app::Chart& chart() const { return chart_; }
    /// The row that is lit; none at first.
    std::optional<std::size_t> currentRow() const { return current_; }

    QSize sizeHint() const override;
    QSize minimumSizeHint() const override;
    int heightForWidth(int width) const override;

signals:
    void exportWanted(); ///< from the context menu

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void focusInEvent(QFocusEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    QRectF area() const;
    void light(std::optional<std::size_t> row);
    void tellRow();

    app::Chart chart_;
    std::optional<std::size_t> current_;
};

} // namespace ui

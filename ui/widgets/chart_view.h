// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/charts/chart.h"
#include "app/view/chart_look.h"

#include <QWidget>

namespace ui {

/// The look of charts in a widget: its palette and font.
app::ChartLook chartLookOf(const QWidget& widget);

/// Shows a chart. A tooltip gives all values of the row that is hovered or selected with the arrow
/// keys. If the widget is lower than the chart's natural height, the rows are squeezed.
class ChartView : public QWidget {
    Q_OBJECT

public:
    explicit ChartView(QWidget* parent = nullptr);

    void setChart(app::Chart chart);
    const app::Chart& chart() const { return chart_; }
    /// The highlighted row; none at first.
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

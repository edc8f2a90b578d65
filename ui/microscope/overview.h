// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"
#include "app/view/view.h"

#include <QLineF>
#include <QPixmap>
#include <QPolygonF>
#include <QWidget>

#include <vector>

namespace ui {

/// The whole drawing in miniature, ghosted, with the clip window, the microscope's line and a frame
/// around what the microscope shows. It ignores the pointer. Of a large drawing it paints only some
/// lines.
class Overview : public QWidget {
    Q_OBJECT

public:
    explicit Overview(const app::Session& session, QWidget* parent = nullptr);

    /// Frames a part of the plane in which the line is traced.
    void showStage(const clipping::Window& stage);
    void forget(); ///< discards the cached picture: the drawing or the clip window has changed

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    app::View view() const;
    std::vector<QLineF> linesIn(const app::View& view) const;
    QPixmap drawing(const app::View& view) const;
    app::WindowFrame frameOf(const app::TracedLine& tracedLine) const;

    QPolygonF stageOn(const app::View& view, const app::WindowFrame& frame) const;

    const app::Session& session_;
    clipping::Window stage_{};
    QPixmap drawing_; ///< the cached picture; null: must be painted
};

} // namespace ui

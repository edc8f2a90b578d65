// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"
#include "app/view/view.h"

#include <QLineF>
#include <QPixmap>
#include <QWidget>

#include <vector>

namespace ui {

/// The whole drawing in miniature, ghosted, with the clip window and the microscope's line, to show
/// its place. It ignores the pointer. Of a large drawing it paints only some lines.
class Overview : public QWidget {
    Q_OBJECT

public:
    explicit Overview(const app::Session& session, QWidget* parent = nullptr);

    void forget(); ///< discards the cached picture: the drawing or the clip window has changed

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    app::View view() const;
    std::vector<QLineF> linesIn(const app::View& view) const;
    QPixmap drawing(const app::View& view) const;
    app::WindowFrame frameOf(const app::TracedLine& tracedLine) const;

    const app::Session& session_;
    QPixmap drawing_; ///< the cached picture; null: must be painted
};

} // namespace ui

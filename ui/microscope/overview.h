// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"
#include "app/view/view.h"

#include <QLineF>
#include <QPixmap>
#include <QWidget>

#include <vector>

namespace ui {

/// The whole drawing in small, ghosted, with the clip window and the line that is looked at: where
/// one is. It lets the pointer through. Of a large drawing it paints some of the lines.
class Overview : public QWidget {
    Q_OBJECT

public:
    explicit Overview(const app::Session& session, QWidget* parent = nullptr);

    void forget(); ///< the drawing or the clip window has changed

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    app::View view() const;
    std::vector<QLineF> linesIn(const app::View& view) const;
    QPixmap drawing(const app::View& view) const;

    const app::Session& session_;
    QPixmap drawing_; ///< null: to be painted
};

} // namespace ui

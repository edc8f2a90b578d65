// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/drawing/dash_patterns.h"
#include "ui/look/look_icon.h"

#include <QIcon>
#include <QWidget>

namespace ui {

/// An icon that is only looked at, in its own colours or in one of the look.
class IconSign : public QWidget {
public:
    IconSign(std::string_view key, int side) : IconSign(icon(key), side) {}
    IconSign(const QIcon& icon, int side) : icon_(icon) { setFixedSize(side, side); }

    void show(std::string_view key, QColor Look::*colour)
    {
        icon_ = icon(key);
        colour_ = colour;
        update();
    }
    void show(const QIcon& icon) ///< in its own colours
    {
        icon_ = icon;
        colour_ = nullptr;
        update();
    }
    using QWidget::show;

protected:
    void paintEvent(QPaintEvent*) override
    {
        QPainter painter(this);
        const Look& look = lookOf(palette());
        if (colour_)
            painter.drawPixmap(rect(), tinted(icon_, size(), devicePixelRatioF(), look.*colour_));
        else
            icon_.paint(&painter, rect());
    }

private:
    QIcon icon_;
    QColor Look::*colour_ = nullptr; ///< null: its own colours
};

QIcon dashIcon(const app::DashPattern& pattern); ///< of 36 × 12 logical pixels

} // namespace ui

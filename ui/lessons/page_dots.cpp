// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/page_dots.h"

#include "ui/look/look.h"
#include "ui/look/text.h"

#include <QPainter>

#include <algorithm>

namespace ui {

namespace {

constexpr int diameter = 8, farthest = 14, nearest = 10; // from centre to centre
constexpr int mostNeeded = 76; // pixels for any number of pages: more dots are smaller

} // namespace

PageDots::PageDots(QWidget* parent) : QWidget(parent)
{
    setSizePolicy(QSizePolicy::Maximum, QSizePolicy::Fixed);
}

void PageDots::show(std::size_t page, std::size_t pages)
{
    page_ = int(page);
    pages_ = int(pages);
    setAccessibleName(Text::tr("Page %1 of %2").arg(page + 1).arg(pages));
    updateGeometry();
    update();
}

QSize PageDots::sizeHint() const { return sizeWith(farthest); }

QSize PageDots::minimumSizeHint() const
{
    const QSize size = sizeWith(nearest);
    return {std::min(size.width(), mostNeeded), size.height()};
}

QSize PageDots::sizeWith(int distance) const
{
    return {pages_ == 0 ? 0 : (pages_ - 1) * distance + diameter, diameter + 2};
}

void PageDots::paintEvent(QPaintEvent*)
{
    const Look& look = lookOf(palette());
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    const double room = double(width() - diameter) / std::max(1, pages_ - 1);
    const double distance = std::min(room, double(farthest));
    const double size = pages_ < 2 ? diameter : std::min(double(diameter), distance - 2);
    for (int i = 0; i < pages_; ++i) {
        painter.setBrush(i == page_ ? look.selection : look.border);
        painter.drawEllipse(QRectF(i * distance, (height() - size) / 2.0, size, size));
    }
}

} // namespace ui

#include "moc_page_dots.cpp"

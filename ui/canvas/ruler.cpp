// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/ruler.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/view/ruler.h"
#include "ui/look/text.h"
#include "ui/widgets/unit_box.h"

#include <QMenu>
#include <QMouseEvent>

#include <cmath>

namespace ui {
namespace {

constexpr int mostType = 15;                                        // pixels
constexpr double typeSize = 0.77, numbered = 9, half = 7, fine = 4; // pixels of a tick's length

QFont rulerFont(const QWidget& widget)
{
    QFont font = widget.font();
    font.setPointSizeF(font.pointSizeF() * typeSize);
    if (QFontMetrics(font).height() > mostType) // the ruler's width does not grow with the font
        font.setPixelSize(mostType * 3 / 4);
    return font;
}

// The number of decimals that the distance between numbers needs.
int decimalsOf(std::span<const app::Tick> ticks)
{
    std::optional<double> first;
    for (const app::Tick& tick : ticks) {
        if (tick.rank != app::Tick::Rank::Numbered)
            continue;
        if (first)
            return std::max(0, -int(std::floor(std::log10(tick.value - *first) + 1e-9)));
        first = tick.value;
    }
    return 0;
}

} // namespace

Ruler::Ruler(Controller& controller, Qt::Orientation orientation, QWidget* parent)
    : QWidget(parent), controller_(controller), orientation_(orientation)
{
    setAttribute(Qt::WA_OpaquePaintEvent);
    setObjectName(across() ? "topRuler" : "leftRuler");
    setCursor(across() ? Qt::SplitVCursor : Qt::SplitHCursor);
    setToolTip(Text::tr("Drag from here to add a guide"));
}

void Ruler::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton)
        return event->ignore();
    controller_.endGesture();
    controller_.pointing().dragGuide(across() ? 1 : 0);
}

// The drawing begins where the rulers end.
void Ruler::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF inside = across() ? QPointF(0, rulerWidth) : QPointF(rulerWidth, 0);
    controller_.pointing().moveGuide(event->position() - inside, event->modifiers());
}

void Ruler::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        controller_.pointing().dropGuide();
}

void Ruler::paintEvent(QPaintEvent*)
{
    const Look& look = controller_.look();
    QPainter painter(this);
    painter.fillRect(rect(), look.window);
    const int axis = across() ? 0 : 1;
    const double length = across() ? width() : height(), pixel = 1 / devicePixelRatioF();
    // Everything is painted as on a horizontal ruler; a vertical ruler is rotated.
    if (!across()) {
        painter.translate(0, length);
        painter.rotate(-90);
    }
    const auto along = [&](double v) { return across() ? v : length - v; };
    if (const auto window = controller_.clipWindow()) {
        const double a = along(controller_.view().toScreen(window->min)[axis]);
        const double b = along(controller_.view().toScreen(window->max)[axis]);
        QColor tint = look.accent;
        tint.setAlphaF(0.18F);
        const double left = std::clamp(std::min(a, b), -1.0, length + 1),
                     right = std::clamp(std::max(a, b), -1.0, length + 1);
        painter.fillRect(QRectF(left, 0, right - left, rulerWidth), tint);
    }
    paintTicks(painter, length);
    painter.fillRect(QRectF(0, rulerWidth - pixel, length, pixel), look.rule);
    if (const auto& pointer = controller_.pointer())
        painter.fillRect(QRectF(std::round(along(pointer->screen[axis])), 0, pixel, rulerWidth),
                         look.text);
}

void Ruler::paintTicks(QPainter& painter, double length)
{
    const app::Page& page = controller_.session().now().page();
    const app::View& view = controller_.view();
    const int axis = across() ? 0 : 1;
    const app::Unit unit = controller_.session().display().unit;
    const double perUnit = app::inUnit(1, unit, page.realMillimetresPerUnit());
    const clipping::Window seen = view.visible();
    const double origin = app::originOf(page, unit)[axis];
    const double from = (seen.min[axis] - origin) * perUnit,
                 to = (seen.max[axis] - origin) * perUnit;
    const double pixels = view.zoom / perUnit, ratio = devicePixelRatioF(), pixel = 1 / ratio;
    painter.setFont(rulerFont(*this));
    const auto all = app::ticks(from, to, pixels);
    const int decimals = decimalsOf(all);
    for (const app::Tick& tick : all) {
        const double at = (tick.value - from) * pixels;
        const double x = std::floor((across() ? at : length - at) * ratio) / ratio;
        const bool number = tick.rank == app::Tick::Rank::Numbered;
        const double size = number ? rulerWidth : tick.rank == app::Tick::Rank::Half ? half : fine;
        painter.fillRect(QRectF(x, rulerWidth - size, pixel, size),
                         number ? controller_.look().rule : controller_.look().muted);
        if (!number)
            continue;
        painter.fillRect(QRectF(x, rulerWidth - numbered, pixel, numbered),
                         controller_.look().muted);
        painter.setPen(controller_.look().muted);
        painter.drawText(QRectF(x + 4, 0, 80, rulerWidth - 6), Qt::AlignLeft | Qt::AlignVCenter,
                         app::numberText(tick.value, decimals));
    }
}

RulerCorner::RulerCorner(const Controller& controller, QWidget* parent)
    : QWidget(parent), controller_(controller)
{
    setAccessibleName(Text::tr("Unit of lengths"));
    setToolTip(Text::tr("Unit of lengths"));
    setCursor(Qt::PointingHandCursor);
}

void RulerCorner::mousePressEvent(QMouseEvent*)
{
    openUnits(controller_.session(), *this, mapToGlobal(rect().bottomLeft()));
}

void RulerCorner::paintEvent(QPaintEvent*)
{
    const Look& look = controller_.look();
    QPainter painter(this);
    painter.fillRect(rect(), look.window);
    painter.setFont(rulerFont(*this));
    painter.setPen(underMouse() ? look.text : look.muted);
    const auto suffix = app::infoOf(controller_.session().display().unit).suffix;
    painter.drawText(rect(), Qt::AlignCenter, app::latin(suffix));
}

} // namespace ui

#include "moc_ruler.cpp"

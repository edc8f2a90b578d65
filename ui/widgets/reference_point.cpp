// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/reference_point.h"

#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/spoken_role.h"

#include <QHelpEvent>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QToolTip>

#include <algorithm>

namespace ui {
namespace {

constexpr int side = 44, square = 8, inset = 6; // logical pixels

QString nameOf(app::Handle handle)
{
    const std::array names{Text::tr("top left"),    Text::tr("top"),    Text::tr("top right"),
                           Text::tr("left"),        Text::tr("middle"), Text::tr("right"),
                           Text::tr("bottom left"), Text::tr("bottom"), Text::tr("bottom right")};
    return names[std::size_t(3 * (handle.y + 1) + handle.x + 1)];
}

} // namespace

ReferencePoint::ReferencePoint(QWidget* parent) : QWidget(parent)
{
    setSpokenRole(*this, QAccessible::Grouping);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Fixed, QSizePolicy::Fixed);
    choose(chosen_);
}

QSize ReferencePoint::sizeHint() const { return {side, side}; }

void ReferencePoint::choose(app::Handle handle)
{
    const bool changes = handle != chosen_;
    chosen_ = handle;
    setAccessibleName(Text::tr("Reference point: %1").arg(nameOf(handle)));
    update();
    if (changes)
        emit changed();
}

QRectF ReferencePoint::squareOf(app::Handle handle) const
{
    const double half = side / 2.0 - inset;
    const QPointF middle(side / 2.0 + handle.x * half, side / 2.0 + handle.y * half);
    return {middle - QPointF(square / 2.0, square / 2.0), QSizeF(square, square)};
}

app::Handle ReferencePoint::handleAt(const QPointF& place) const
{
    const auto third = [](double along) { return std::clamp(int(along * 3 / side), 0, 2) - 1; };
    return {third(place.x()), third(place.y())};
}

void ReferencePoint::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const Look& look = lookOf(palette());
    const QColor line = isEnabled() ? look.control : look.border;
    painter.setPen(QPen(line, 1));
    painter.drawRect(QRectF(inset, inset, side - 2 * inset, side - 2 * inset));
    for (int y = -1; y <= 1; ++y)
        for (int x = -1; x <= 1; ++x) {
            const bool isChosen = app::Handle{x, y} == chosen_ && isEnabled();
            const QColor colour = isChosen ? look.selection : line;
            painter.setPen(QPen(colour, 1));
            painter.setBrush(isChosen ? look.selection : look.base);
            painter.drawRect(squareOf({x, y}));
        }
    if (!hasFocus())
        return;
    painter.setPen(QPen(look.selection, 2));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(rect()).adjusted(1, 1, -1, -1));
}

void ReferencePoint::mousePressEvent(QMouseEvent* event)
{
    if (event->button() == Qt::LeftButton)
        choose(handleAt(event->position()));
}

void ReferencePoint::keyPressEvent(QKeyEvent* event)
{
    app::Handle next = chosen_;
    const int key = event->key();
    if (key == Qt::Key_Left || key == Qt::Key_Right)
        next.x = std::clamp(next.x + (key == Qt::Key_Left ? -1 : 1), -1, 1);
    else if (key == Qt::Key_Up || key == Qt::Key_Down)
        next.y = std::clamp(next.y + (key == Qt::Key_Up ? -1 : 1), -1, 1);
    else
        return QWidget::keyPressEvent(event);
    choose(next);
}

bool ReferencePoint::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip) {
        const auto& help = static_cast<const QHelpEvent&>(*event);
        QToolTip::showText(help.globalPos(),
                           Text::tr("X and Y of the %1; resizing and turning keep it in place")
                               .arg(nameOf(handleAt(help.pos()))),
                           this);
        return true;
    }
    return QWidget::event(event);
}

} // namespace ui

#include "moc_reference_point.cpp"

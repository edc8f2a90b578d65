// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/magnifier_view.h"

#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/chart_view.h"
#include "ui/widgets/spoken_role.h"

#include <QKeyEvent>
#include <QPainter>
#include <QWheelEvent>

#include <cmath>

namespace ui {

namespace {

constexpr double keyZoom = 2, pageZoom = 16, keyMove = 40; // pixels
constexpr double notch = 120, notchZoom = 1.5;

} // namespace

Magnifier::Magnifier(QWidget* parent) : QWidget(parent)
{
    setSpokenRole(*this, QAccessible::Graphic);
    setFocusPolicy(Qt::StrongFocus);
    setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Expanding);
    setCursor(Qt::OpenHandCursor);
    setAccessibleName(Text::tr("Magnifier"));
}

void Magnifier::show(const app::Magnified& seen, const QString& name)
{
    seen_ = seen;
    name_ = name;
    setAccessibleDescription(app::magnifiedText(seen, name));
    reset();
}

void Magnifier::setLattice(app::Lattice lattice)
{
    view_.lattice = lattice;
    update();
}

void Magnifier::reset()
{
    const app::Lattice lattice = view_.lattice;
    view_ = app::usualView(seen_, size());
    view_.lattice = lattice;
    touched_ = false;
    update();
}

void Magnifier::zoom(double factor, const QPointF& about)
{
    view_ = app::zoomed(view_, seen_, factor, about);
    touched_ = true;
    update();
}

void Magnifier::paintEvent(QPaintEvent*)
{
    const Look& look = lookOf(palette());
    app::MagnifierLook colours{chartLookOf(*this), look.accent, look.selection, look.differs,
                               look.hover};
    colours.chart.font = captionFont(font());
    colours.chart.paper = look.base;
    QPainter painter(this);
    app::paintMagnified(painter, rect(), {seen_, name_}, view_, colours);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(hasFocus() ? QPen(look.selection, 2) : QPen(look.rule, 1));
    painter.drawRect(rect().adjusted(0, 0, -1, -1));
}

void Magnifier::wheelEvent(QWheelEvent* event)
{
    const QPointF about = event->position() - QRectF(rect()).center();
    zoom(std::pow(notchZoom, event->angleDelta().y() / notch), about);
    event->accept();
}

void Magnifier::mousePressEvent(QMouseEvent* event) { last_ = event->position(); }

void Magnifier::mouseMoveEvent(QMouseEvent* event)
{
    if (!(event->buttons() & Qt::LeftButton))
        return;
    view_.middle += event->position() - last_;
    last_ = event->position();
    touched_ = true;
    update();
}

void Magnifier::keyPressEvent(QKeyEvent* event)
{
    const auto move = [this](double x, double y) {
        view_.middle += QPointF(x, y) * keyMove;
        touched_ = true;
        update();
    };
    switch (event->key()) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
        return zoom(keyZoom, {});
    case Qt::Key_Minus:
        return zoom(1 / keyZoom, {});
    case Qt::Key_PageUp:
        return zoom(pageZoom, {});
    case Qt::Key_PageDown:
        return zoom(1 / pageZoom, {});
    case Qt::Key_Home:
        return reset();
    case Qt::Key_Left:
        return move(1, 0);
    case Qt::Key_Right:
        return move(-1, 0);
    case Qt::Key_Up:
        return move(0, 1);
    case Qt::Key_Down:
        return move(0, -1);
    default:
        QWidget::keyPressEvent(event);
    }
}

void Magnifier::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    if (!touched_)
        reset();
}

void Magnifier::focusInEvent(QFocusEvent* event)
{
    QWidget::focusInEvent(event);
    update();
}

void Magnifier::focusOutEvent(QFocusEvent* event)
{
    QWidget::focusOutEvent(event);
    update();
}

} // namespace ui

#include "moc_magnifier_view.cpp"

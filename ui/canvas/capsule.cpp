// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/capsule.h"

#include "ui/look/look.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/elements.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/spoken_role.h"

#include <QApplication>
#include <QContextMenuEvent>
#include <QHBoxLayout>
#include <QPainter>

namespace ui {
namespace {

constexpr int aroundRing = 2, ringWidth = 1, besideParts = 5; // pixels
constexpr int usualNumberWidth = 62, ruleHeight = 16;
constexpr int stillMilliseconds = 200; // after the last change of the view
constexpr int deafMilliseconds = 250;  // a click that was meant for the canvas does nothing

} // namespace

Capsule::Capsule(Controller& controller, QWidget* parent)
    : QFrame(parent), controller_(controller), canvas_(parent)
{
    setSpokenRole(*this, QAccessible::ToolBar);
    auto* row = new QHBoxLayout(this);
    row->setSizeConstraint(QLayout::SetFixedSize);
    row->setSpacing(besideParts);
    setMargins();
    hide();
    still_.setSingleShot(true);
    still_.setInterval(stillMilliseconds);
    deaf_.setSingleShot(true);
    deaf_.setInterval(deafMilliseconds);
    connect(&deaf_, &QTimer::timeout, this,
            [this] { setAttribute(Qt::WA_TransparentForMouseEvents, false); });
    connect(&still_, &QTimer::timeout, this, &Capsule::follow);
    connect(&controller.navigation(), &Navigation::moved, this, &Capsule::hideWhileMoving);
    connect(&controller, &Controller::changed, this, [this] {
        if (isHidden() == (isWanted() && !noRoom_))
            follow();
    });
    connect(&controller, &Controller::capsuleWanted, this, &Capsule::enter);
    followSession();
}

void Capsule::followSession()
{
    const app::Session& session = controller_.session();
    connect(&session, &app::Session::loaded, this, [this] {
        if (hasKeyboard())
            forget(); // it was for a thing of the drawing before
        follow();
    });
    for (const auto signal : {&app::Session::previewChanged, &app::Session::displayChanged,
                              &app::Session::selectionChanged})
        connect(&session, signal, this, &Capsule::follow);
}

void Capsule::addPart(QWidget& part, int place)
{
    static_cast<QHBoxLayout*>(layout())->insertWidget(place, &part);
    for (LengthField* field : part.findChildren<LengthField*>())
        adopt(*field);
}

QWidget* Capsule::addRule(int place)
{
    QFrame* line = rule(Qt::Vertical);
    line->setFixedHeight(ruleHeight);
    addPart(*line, place);
    return line;
}

void Capsule::addMore(const QString& tip)
{
    QToolButton* more = iconButton("more", tip);
    more->setObjectName(objectName() + QStringLiteral("-more"));
    connect(more, &QToolButton::clicked, this, [this] {
        leave();
        emit menuWanted(mapToGlobal(rect().bottomRight()));
    });
    addPart(*more);
}

/// It looks like text until it is used.
LengthField* Capsule::makeField(const QString& name, const QString& objectName, bool angle)
{
    using Range = LengthField::Range;
    using Suffix = LengthField::Suffix;
    auto* field = new LengthField(name, angle ? Range::Any : Range::NotNegative,
                                  angle ? Suffix::Degrees : Suffix::None);
    field->setObjectName(objectName);
    field->setButtonSymbols(QAbstractSpinBox::NoButtons);
    field->setFrame(false);
    field->setFixedWidth(usualNumberWidth);
    field->setFocusPolicy(Qt::StrongFocus);
    adopt(*field);
    return field;
}

void Capsule::adopt(LengthField& field)
{
    field.installEventFilter(this); // the wheel is for the canvas
    connect(&field, &LengthField::entered, this, &Capsule::leave);
    connect(&field, &LengthField::refused, this, &Capsule::refused);
    connect(&field, &LengthField::taken, this, &Capsule::taken);
    fields_.push_back(&field);
}

void Capsule::setSurface(QWidget* surface, Form form)
{
    if (hasKeyboard())
        leave();
    surface_ = surface;
    setForm(form);
    placedAt_.reset(); // it has another place
    follow();
}

void Capsule::setHome(app::CapsuleHome home, QWidget* bar)
{
    if (hasKeyboard())
        leave();
    withdraw();
    home_ = home;
    setParent(bar ? bar : canvas_);
    if (bar)
        bar->layout()->addWidget(this);
    setAttribute(Qt::WA_TransparentForMouseEvents, false);
    setMargins();
    placedAt_.reset();
    follow();
}

/// On the canvas it has a ring.
void Capsule::setMargins()
{
    const int edge = isInBar() ? 0 : aroundRing + ringWidth;
    const int beside = isInBar() ? 0 : edge + besideParts;
    layout()->setContentsMargins(beside, edge, beside, edge);
}

void Capsule::settle()
{
    still_.stop();
    follow();
}

void Capsule::enter()
{
    const auto first = std::ranges::find_if(
        fields_, [this](const LengthField* field) { return field->isVisibleTo(this); });
    if (isHidden() || first == fields_.end())
        return;
    (*first)->setFocus(Qt::TabFocusReason);
    (*first)->selectAll();
}

void Capsule::leave()
{
    if (QWidget* focus = QApplication::focusWidget(); focus && isAncestorOf(focus))
        focus->clearFocus(); // also if the surface is hidden and cannot take it
    if (surface_)
        surface_->setFocus();
    follow(); // to where the thing is now
}

void Capsule::forget()
{
    for (LengthField* field : fields_)
        field->discardTyped();
    leave();
}

bool Capsule::isWanted() const
{
    if (home_ == app::CapsuleHome::Off || !surface_ || !isFor()
        || controller_.session().display().presenting)
        return false;
    return isInBar()
           || (!still_.isActive() && !controller_.gestureGoes() && !controller_.typing().going());
}

bool Capsule::hasKeyboard() const
{
    const QWidget* focus = QApplication::focusWidget();
    return focus && isAncestorOf(focus);
}

bool Capsule::holds() const { return isVisible() && (underMouse() || hasKeyboard()); }

void Capsule::follow()
{
    const bool isOther = followSubject();
    if (hasKeyboard() && (isOther || !isWanted()))
        forget();
    noRoom_ = false;
    afterGesture_ = afterGesture_ || controller_.gestureGoes();
    if (!isWanted())
        return withdraw();
    showValues();
    if (isInBar())
        return showInBar();
    if (isOther || !holds() || !placedAt_)
        place(isOther || !placedAt_);
}

void Capsule::hideWhileMoving()
{
    if (hasKeyboard() || isInBar())
        return;
    still_.start();
    follow();
}

void Capsule::withdraw()
{
    hide();
    if (controller_.capsule() == this)
        controller_.setCapsule(nullptr, {});
    if (!std::exchange(inBar_, QSize()).isEmpty())
        emit barOutdated();
}

void Capsule::showInBar()
{
    show();
    controller_.setCapsule(this, {});
    layout()->invalidate(); // or its size is that of before, until events are handled
    layout()->activate();
    const QSize room = sizeHint();
    if (std::exchange(inBar_, room) != room)
        emit barOutdated();
}

void Capsule::place(bool isOther)
{
    adjustSize();
    app::CapsuleRoom around = room();
    // The side stays where the pointer let the thing go, also when keys or numbers move it. A click
    // that changes nothing does not move the capsule.
    const app::WindowFrame now = frame();
    const auto& pointer = controller_.pointer();
    if (pointer && (isOther || (afterGesture_ && placedAt_ != now)))
        released_ = QPointF(pointer->screen.x, pointer->screen.y) - around.box.center();
    afterGesture_ = false;
    placedAt_ = now;
    around.canvas = surface_->size();
    if (released_)
        around.released = around.box.center() + *released_;
    const auto at = app::capsulePlace(size(), around);
    noRoom_ = !at;
    if (noRoom_)
        return withdraw();
    const QPoint corner = surface_->mapTo(parentWidget(), at->toPoint());
    if (isHidden() || corner != pos())
        beDeaf();
    move(corner);
    show();
    raise();
    update();
    controller_.setCapsule(this, QRectF(*at, size()));
}

/// A click that was meant for what it has just covered still reaches that.
void Capsule::beDeaf()
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    deaf_.start();
}

/// The wheel over a field is for the canvas; a click on a field selects all of it.
bool Capsule::eventFilter(QObject* watched, QEvent* event)
{
    auto* field = qobject_cast<LengthField*>(watched);
    if (event->type() == QEvent::FocusIn && field
        && static_cast<QFocusEvent*>(event)->reason() == Qt::MouseFocusReason)
        QMetaObject::invokeMethod(field, &LengthField::selectAll, Qt::QueuedConnection);
    if (event->type() != QEvent::Wheel)
        return QFrame::eventFilter(watched, event);
    wheelEvent(static_cast<QWheelEvent*>(event));
    return true;
}

void Capsule::wheelEvent(QWheelEvent* event)
{
    event->accept();
    if (isInBar())
        return; // it is not over the drawing
    QWheelEvent there(surface_->mapFromGlobal(event->globalPosition()), event->globalPosition(),
                      event->pixelDelta(), event->angleDelta(), event->buttons(),
                      event->modifiers(), event->phase(), event->inverted());
    QCoreApplication::sendEvent(surface_, &there);
}

void Capsule::leaveEvent(QEvent*)
{
    if (!hasKeyboard())
        follow();
}

void Capsule::contextMenuEvent(QContextMenuEvent* event)
{
    emit menuWanted(event->globalPos());
    event->accept();
}

void Capsule::keyPressEvent(QKeyEvent* event)
{
    if (event->key() != Qt::Key_Escape)
        return QFrame::keyPressEvent(event);
    leave();
}

void Capsule::paintEvent(QPaintEvent*)
{
    if (isInBar())
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(controller_.pageColour());
    painter.drawRoundedRect(rect(), space::radius + aroundRing, space::radius + aroundRing);
    const double inset = aroundRing + ringWidth / 2.0;
    painter.setPen(QPen(ringColour(), ringWidth));
    painter.setBrush(controller_.look().base);
    painter.drawRoundedRect(QRectF(rect()).adjusted(inset, inset, -inset, -inset), space::radius,
                            space::radius);
}

} // namespace ui

#include "moc_capsule.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/capsule.h"

#include "app/session/window_operations.h"
#include "app/session/window_steps.h"
#include "app/session/window_values.h"
#include "app/session/window_words.h"
#include "app/view/capsule_place.h"
#include "ui/canvas/window_overlay.h"
#include "ui/canvas/window_tags.h"
#include "ui/editing/keeping.h"
#include "ui/look/text.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/unit_box.h"

#include <QActionGroup>
#include <QApplication>
#include <QContextMenuEvent>
#include <QHBoxLayout>
#include <QMenu>
#include <QPainter>

namespace ui {
namespace {

constexpr int aroundRing = 2, ringWidth = 1, besideParts = 5; // pixels
constexpr int numberWidth = 62;
constexpr int stillMilliseconds = 200; // after the last change of the view
constexpr int deafMilliseconds = 250;  // a click that was meant for the canvas does nothing

QString tipOf(const app::WindowOperationInfo& operation)
{
    return Text::tr("%1 (%2)").arg(operation.tip, operation.letter);
}

Segments* operationSegments()
{
    QStringList names, tips;
    std::vector<std::string_view> icons;
    for (const app::WindowOperationInfo& each : app::windowOperations()) {
        names << each.name;
        tips << tipOf(each);
        icons.push_back(each.icon);
    }
    auto* segments = new Segments(Text::tr("What the window does"), names);
    segments->setIcons(icons);
    segments->setTips(tips);
    segments->setObjectName(QStringLiteral("capsule-operation"));
    return segments;
}

} // namespace

Capsule::Capsule(Controller& controller, QWidget* parent)
    : QFrame(parent), controller_(controller), operation_(operationSegments()),
      keep_(new Segments(Text::tr("Keep"), {Text::tr("Inside"), Text::tr("Outside")})),
      operationChoice_(new QActionGroup(this)), operations_(makeOperations()),
      more_(iconButton("more", Text::tr("More commands for the clip window"))),
      width_(makeField(app::WindowValue::Width)), height_(makeField(app::WindowValue::Height)),
      unit_(new UnitButton(controller.session()))
{
    setObjectName(QStringLiteral("capsule"));
    keep_->setObjectName(QStringLiteral("capsule-keep"));
    keep_->setTips({Text::tr("Keep what lies inside all windows together (X: the other side)"),
                    Text::tr("Keep what lies outside all windows together (X: the other side)")});
    more_->setObjectName(QStringLiteral("capsule-more"));
    auto* row = new QHBoxLayout(this);
    row->setSizeConstraint(QLayout::SetFixedSize);
    const int edge = aroundRing + ringWidth;
    row->setContentsMargins(edge + besideParts, edge, edge + besideParts, edge);
    row->setSpacing(besideParts);
    auto* times = new QLabel(QStringLiteral("×"));
    times->setForegroundRole(QPalette::PlaceholderText);
    for (QWidget* part : {static_cast<QWidget*>(operation_), static_cast<QWidget*>(operations_),
                          static_cast<QWidget*>(width_), static_cast<QWidget*>(times),
                          static_cast<QWidget*>(height_), static_cast<QWidget*>(unit_),
                          static_cast<QWidget*>(keep_), static_cast<QWidget*>(more_)})
        row->addWidget(part);
    hide();
    still_.setSingleShot(true);
    still_.setInterval(stillMilliseconds);
    deaf_.setSingleShot(true);
    deaf_.setInterval(deafMilliseconds);
    connect(&deaf_, &QTimer::timeout, this,
            [this] { setAttribute(Qt::WA_TransparentForMouseEvents, false); });
    const app::Session& session = controller.session();
    connect(operation_, &Segments::picked, this, &Capsule::setOperation);
    connect(keep_, &Segments::picked, this, [this](int side) {
        leave();
        setKeep(controller_.session(), app::Keep(side));
    });
    connect(more_, &QToolButton::clicked, this, [this] {
        leave();
        emit menuWanted(mapToGlobal(rect().bottomRight()));
    });
    connect(&still_, &QTimer::timeout, this, &Capsule::follow);
    connect(&controller, &Controller::viewChanged, this, &Capsule::hideWhileMoving);
    connect(&controller, &Controller::changed, this, [this] {
        if (isHidden() == isWanted())
            follow();
    });
    connect(&controller, &Controller::capsuleWanted, this, &Capsule::enter);
    connect(&session, &app::Session::loaded, this, [this] {
        if (hasKeyboard())
            forget(); // it was for a window of the drawing before
        shown_ = {};
        follow();
    });
    for (const auto signal : {&app::Session::previewChanged, &app::Session::displayChanged,
                              &app::Session::selectionChanged})
        connect(&session, signal, this, &Capsule::follow);
}

QToolButton* Capsule::makeOperations()
{
    auto* button = iconButton("window-add", Text::tr("What the window does"));
    button->setObjectName(QStringLiteral("capsule-operations"));
    button->setPopupMode(QToolButton::InstantPopup);
    button->setStyleSheet(QStringLiteral("QToolButton::menu-indicator { image: none; }"));
    auto* menu = new QMenu(button);
    for (const app::WindowOperationInfo& each : app::windowOperations()) {
        QAction* action = menu->addAction(icon(each.icon), tipOf(each));
        action->setCheckable(true);
        action->setData(int(operationChoice_->actions().size()));
        operationChoice_->addAction(action);
    }
    connect(operationChoice_, &QActionGroup::triggered, this,
            [this](QAction* action) { setOperation(action->data().toInt()); });
    button->setMenu(menu);
    return button;
}

LengthField* Capsule::makeField(app::WindowValue which)
{
    const bool isWidth = which == app::WindowValue::Width;
    auto* field = new LengthField(isWidth ? Text::tr("Width") : Text::tr("Height"),
                                  LengthField::Range::NotNegative, LengthField::Suffix::None);
    field->setObjectName(isWidth ? QStringLiteral("capsule-width")
                                 : QStringLiteral("capsule-height"));
    field->setButtonSymbols(QAbstractSpinBox::NoButtons);
    field->setFrame(false); // it looks like text until it is used
    field->setAlignment(isWidth ? Qt::AlignRight : Qt::AlignLeft);
    field->setFixedWidth(numberWidth);
    field->setToolTip(isWidth ? Text::tr("Width of the clip window (Enter)")
                              : Text::tr("Height of the clip window"));
    field->setFocusPolicy(Qt::StrongFocus);
    field->installEventFilter(this); // the wheel is for the canvas
    connect(field, &LengthField::edited, this,
            [this, which](double length, app::Merging merging) { set(which, length, merging); });
    connect(field, &LengthField::entered, this, &Capsule::leave);
    connect(field, &LengthField::refused, this, &Capsule::refused);
    connect(field, &LengthField::taken, this, &Capsule::taken);
    return field;
}

void Capsule::setSurface(QWidget* surface, Form form)
{
    if (hasKeyboard())
        leave();
    surface_ = surface;
    operation_->setVisible(form == Form::Whole);
    keep_->setVisible(form == Form::Whole);
    unit_->setVisible(form == Form::Whole);
    operations_->setVisible(form == Form::Compact);
    shown_ = {}; // it has another place
    follow();
}

void Capsule::switchOn(bool on)
{
    on_ = on;
    follow();
}

void Capsule::settle()
{
    still_.stop();
    follow();
}

void Capsule::setOperation(int operation)
{
    leave();
    app::Session& session = controller_.session();
    if (const auto number = session.windowNumber())
        app::setWindowOperation(session, *number, app::WindowOperation(operation));
}

/// Of the window that was shown when it was typed.
void Capsule::set(app::WindowValue which, double length, app::Merging merging)
{
    if (controller_.session().windowNumber() == shown_.number)
        app::setWindowValue(controller_.session(), which, length, false, merging);
}

void Capsule::enter()
{
    if (isHidden())
        return;
    width_->setFocus(Qt::TabFocusReason);
    width_->selectAll();
}

void Capsule::leave()
{
    if (surface_)
        surface_->setFocus();
    follow(); // to where the window is now
}

void Capsule::forget()
{
    width_->discardTyped();
    height_->discardTyped();
    leave();
}

bool Capsule::isWanted() const
{
    const app::Session& session = controller_.session();
    return on_ && surface_ && !still_.isActive() && session.windowFrame()
           && controller_.actsOnWindow() && !session.display().presenting
           && !controller_.gestureGoes() && !controller_.typing();
}

bool Capsule::hasKeyboard() const
{
    const QWidget* focus = QApplication::focusWidget();
    return focus && isAncestorOf(focus);
}

bool Capsule::holds() const { return isVisible() && (underMouse() || hasKeyboard()); }

void Capsule::follow()
{
    const app::Session& session = controller_.session();
    const auto number = session.windowNumber();
    const Shown now{number, number ? app::nameOf(session.windows().list[*number]) : QString()};
    const bool isOther = std::exchange(shown_, now) != now;
    if (hasKeyboard() && (isOther || !isWanted()))
        forget();
    if (!isWanted()) {
        hide();
        return controller_.setCapsulePlace({});
    }
    showValues();
    if (isOther || !holds())
        place();
}

void Capsule::hideWhileMoving()
{
    if (hasKeyboard())
        return;
    still_.start();
    follow();
}

void Capsule::showValues()
{
    const app::Session& session = controller_.session();
    const app::ClipWindow& window = session.windows().list[*session.windowNumber()];
    setAccessibleName(Text::tr("%1, clip window").arg(app::nameOf(window)));
    operation_->choose(int(window.operation));
    QAction* chosen = operationChoice_->actions().at(int(window.operation));
    chosen->setChecked(true);
    operations_->setIcon(chosen->icon());
    keep_->choose(int(session.windows().keep));
    for (const auto& [field, which] :
         {std::pair(width_, app::WindowValue::Width), std::pair(height_, app::WindowValue::Height)})
        if (!field->isBeingTyped())
            field->show(app::windowValue(session, which), session.display().unit,
                        session.now().page().millimetresPerUnit());
}

void Capsule::place()
{
    adjustSize();
    // A click that changes nothing does not move it.
    const auto& frame = controller_.session().windowFrame();
    const auto& pointer = controller_.pointer();
    if (std::exchange(placedAt_, frame) != frame && pointer)
        released_ = QPointF(pointer->screen.x, pointer->screen.y);
    const auto at =
        app::capsulePlace(size(), {.canvas = surface_->size(),
                                   .box = windowBox(controller_),
                                   .covered = windowMarks(controller_, surface_->font()),
                                   .released = released_});
    const QPoint corner = at ? surface_->mapTo(parentWidget(), at->toPoint()) : pos();
    if (isHidden() || corner != pos())
        beDeaf();
    move(corner);
    setVisible(at.has_value());
    raise();
    update();
    controller_.setCapsulePlace(at ? QRectF(*at, size()) : QRectF());
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
    QWheelEvent there(surface_->mapFromGlobal(event->globalPosition()), event->globalPosition(),
                      event->pixelDelta(), event->angleDelta(), event->buttons(),
                      event->modifiers(), event->phase(), event->inverted());
    QCoreApplication::sendEvent(surface_, &there);
    event->accept();
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
    const auto number = controller_.session().windowNumber();
    if (!number)
        return;
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setPen(Qt::NoPen);
    painter.setBrush(controller_.pageColour());
    painter.drawRoundedRect(rect(), space::radius + aroundRing, space::radius + aroundRing);
    const double inset = aroundRing + ringWidth / 2.0;
    painter.setPen(
        QPen(colourOf(controller_.session().windows().list[*number], controller_), ringWidth));
    painter.setBrush(controller_.look().base);
    painter.drawRoundedRect(QRectF(rect()).adjusted(inset, inset, -inset, -inset), space::radius,
                            space::radius);
}

} // namespace ui

#include "moc_capsule.cpp"

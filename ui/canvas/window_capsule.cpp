// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/window_capsule.h"

#include "app/document/window_operations.h"
#include "app/session/window_steps.h"
#include "app/session/window_words.h"
#include "ui/canvas/window_overlay.h"
#include "ui/canvas/window_tags.h"
#include "ui/look/key_tip.h"
#include "ui/look/text.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/segments.h"
#include "ui/widgets/unit_box.h"

#include <QActionGroup>
#include <QMenu>

namespace ui {
namespace {

QString tipOf(const app::WindowOperationInfo& operation)
{
    return app::withKeys(operation.tip + QStringLiteral(" ({%1})").arg(app::latin(operation.key)));
}

Segments* operationSegments()
{
    QStringList names;
    std::vector<std::string_view> icons;
    for (const app::WindowOperationInfo& each : app::windowOperations()) {
        names << each.name;
        icons.push_back(each.icon);
    }
    auto* segments = new Segments(Text::tr("What the window does"), names);
    segments->setIcons(icons);
    segments->setObjectName(QStringLiteral("capsule-operation"));
    return segments;
}

} // namespace

WindowCapsule::WindowCapsule(Controller& controller, QWidget* parent)
    : Capsule(controller, parent), operation_(operationSegments()),
      operationChoice_(new QActionGroup(this)), operations_(makeOperations()),
      width_(makeSide(app::WindowValue::Width)), height_(makeSide(app::WindowValue::Height)),
      unit_(new UnitButton(controller.session()))
{
    setObjectName(QStringLiteral("capsule"));
    followKeys(*this, [this] { showTips(); });
    for (QWidget* part :
         {static_cast<QWidget*>(operation_), static_cast<QWidget*>(operations_),
          static_cast<QWidget*>(width_), static_cast<QWidget*>(quietLabel(QStringLiteral("×"))),
          static_cast<QWidget*>(height_), static_cast<QWidget*>(unit_)})
        addPart(*part);
    addMore(Text::tr("More commands for the clip window"));
    connect(operation_, &Segments::picked, this, &WindowCapsule::setOperation);
}

/// They name keys, which the person may change.
void WindowCapsule::showTips()
{
    QStringList tips;
    for (const app::WindowOperationInfo& each : app::windowOperations()) {
        operationChoice_->actions().at(tips.size())->setText(tipOf(each));
        tips << tipOf(each);
    }
    operation_->setTips(tips);
}

QToolButton* WindowCapsule::makeOperations()
{
    auto* button = iconButton("window-add", Text::tr("What the window does"));
    button->setObjectName(QStringLiteral("capsule-operations"));
    button->setPopupMode(QToolButton::InstantPopup);
    button->setStyleSheet(QStringLiteral("QToolButton::menu-indicator { image: none; }"));
    auto* menu = new QMenu(button);
    menu->setToolTipsVisible(true);
    for (const app::WindowOperationInfo& each : app::windowOperations()) {
        QAction* action = menu->addAction(icon(each.icon), QString());
        action->setCheckable(true);
        action->setData(int(operationChoice_->actions().size()));
        operationChoice_->addAction(action);
    }
    connect(operationChoice_, &QActionGroup::triggered, this,
            [this](QAction* action) { setOperation(action->data().toInt()); });
    button->setMenu(menu);
    return button;
}

LengthField* WindowCapsule::makeSide(app::WindowValue which)
{
    const bool isWidth = which == app::WindowValue::Width;
    auto* field = isWidth ? makeField(Text::tr("Width"), QStringLiteral("capsule-width"))
                          : makeField(Text::tr("Height"), QStringLiteral("capsule-height"));
    field->setAlignment(isWidth ? Qt::AlignRight : Qt::AlignLeft);
    field->setToolTip(
        isWidth ? Text::tr("Width of the clip window (Enter). Shift+Enter keeps its proportions.")
                : Text::tr("Height of the clip window. Shift+Enter keeps its proportions."));
    connect(field, &LengthField::edited, this,
            [this, which, field](double length, app::Merging merging) {
                set(which, length, field->entersWithShift(), merging);
            });
    return field;
}

void WindowCapsule::setForm(Form form)
{
    operation_->setVisible(form == Form::Whole);
    unit_->setVisible(form == Form::Whole);
    operations_->setVisible(form == Form::Compact);
}

void WindowCapsule::setOperation(int operation)
{
    leave();
    app::Session& session = controller().session();
    if (const auto number = session.windowNumber())
        app::setWindowOperation(session, *number, app::WindowOperation(operation));
}

/// Of the window that was shown when it was typed.
void WindowCapsule::set(app::WindowValue which, double length, bool proportional,
                        app::Merging merging)
{
    if (controller().session().windowNumber() == shown_.number)
        app::setWindowValue(controller().session(), which, length, proportional, merging);
}

bool WindowCapsule::isFor() const
{
    return controller().session().windowFrame() && controller().actsOnWindow();
}

bool WindowCapsule::followSubject()
{
    const app::Session& session = controller().session();
    const auto number = session.windowNumber();
    const Shown now{number, number ? app::nameOf(session.windows().list[*number]) : QString()};
    return std::exchange(shown_, now) != now;
}

void WindowCapsule::showValues()
{
    const app::Session& session = controller().session();
    const app::ClipWindow& window = session.windows().list[*session.windowNumber()];
    setAccessibleName(app::chosenText(session, true));
    for (const app::WindowOperationInfo& each : app::windowOperations()) {
        const QString why = app::whyNot(session.windows(), *session.windowNumber(), each.operation);
        operation_->setReason(int(each.operation), why);
        QAction* action = operationChoice_->actions().at(int(each.operation));
        action->setEnabled(why.isEmpty());
        action->setToolTip(why);
    }
    operation_->choose(int(window.operation));
    QAction* chosen = operationChoice_->actions().at(int(window.operation));
    chosen->setChecked(true);
    operations_->setIcon(chosen->icon());
    for (const auto& [field, which] :
         {std::pair(width_, app::WindowValue::Width), std::pair(height_, app::WindowValue::Height)})
        if (!field->isBeingTyped())
            field->show(app::windowValue(session, which), session.display().unit,
                        session.now().page().realMillimetresPerUnit());
}

app::WindowFrame WindowCapsule::frame() const { return *controller().session().windowFrame(); }

app::CapsuleRoom WindowCapsule::room() const
{
    return {.box = windowBox(controller()),
            .covered = windowMarks(controller(), surface()->font())};
}

QColor WindowCapsule::ringColour() const
{
    const app::Session& session = controller().session();
    const auto number = session.windowNumber();
    return number ? colourOf(session.windows().list[*number], controller().bench()) : QColor();
}

} // namespace ui

#include "moc_window_capsule.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/canvas/object_capsule.h"

#include "app/session/units.h"
#include "app/session/window_words.h"
#include "ui/canvas/text_row.h"
#include "ui/canvas/window_offer.h"
#include "ui/canvas/window_overlay.h"
#include "ui/look/text.h"
#include "ui/tools/end_drag.h"
#include "ui/tools/selection_marks.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/unit_box.h"

namespace ui {
namespace {

constexpr int numberWidth = 54, widerNumber = 66; // pixels
constexpr std::string_view ofWidth = "w", ofHeight = "h", ofLength = "length", ofAngle = "angle";

const app::SelectionNumber& infoOf(std::string_view key)
{
    return *std::ranges::find(app::selectionNumbers(), key, &app::SelectionNumber::key);
}

} // namespace

ObjectCapsule::ObjectCapsule(Controller& controller, QWidget* parent)
    : Capsule(controller, parent), text_(new TextRow(controller.session())),
      times_(quietLabel(QStringLiteral("×"))), unit_(new UnitButton(controller.session()))
{
    setObjectName(QStringLiteral("object-capsule"));
    addNumber(ofLength, true);
    addNumber(ofWidth, true);
    addPart(*times_);
    addNumber(ofHeight, false);
    addPart(*text_);
    connect(text_, &TextRow::done, this, &ObjectCapsule::leave);
    unit_->setFocusPolicy(Qt::NoFocus); // Tab goes on to the angle
    addPart(*unit_);
    beforeAngle_ = addRule();
    addNumber(ofAngle, true);
    addRule();
    addMore(Text::tr("More commands for the selected objects"));
    const app::Session& session = controller.session();
    connect(&session.nodes, &app::NodeEditing::changed, this, &ObjectCapsule::follow);
    connect(&session.document, &app::EditedDocument::changed, this, &ObjectCapsule::follow,
            Qt::QueuedConnection); // the selection may not be updated yet
}

void ObjectCapsule::addNumber(std::string_view key, bool labelled)
{
    const app::SelectionNumber& info = infoOf(key);
    const bool isAngle = info.quantity == app::Quantity::Angle;
    auto* field =
        makeField(info.name, QStringLiteral("object-capsule-") + app::latin(key), isAngle);
    field->setFixedWidth(key == ofAngle || key == ofLength ? widerNumber : numberWidth);
    field->setAlignment(key == ofHeight ? Qt::AlignLeft : Qt::AlignRight);
    field->setToolTip(info.name);
    connect(field, &LengthField::edited, this, [this, &info](double value, app::Merging merging) {
        app::Session& session = controller().session();
        if (session.selection() != shown_)
            return; // it was typed for other objects
        if (const auto refusal = app::setSelectionNumber(session, info, {}, value, merging))
            emit session.refused(*refusal);
        follow();
    });
    QLabel* label = labelled ? quietLabel(info.label) : nullptr;
    if (label)
        addPart(*label);
    addPart(*field);
    numbers_.push_back({&info, label, field});
}

void ObjectCapsule::setStyle(QWidget& style, std::function<void()> follow)
{
    addRule(0);
    addPart(style, 0);
    followStyle_ = std::move(follow);
}

void ObjectCapsule::setForm(Form form)
{
    form_ = form;
    unit_->setVisible(form == Form::Whole);
    beforeAngle_->setVisible(form == Form::Whole);
    text_->setCompact(form == Form::Compact);
}

bool ObjectCapsule::isFor() const
{
    const app::Session& session = controller().session();
    return controller().toolInfo().options == ToolInfo::Options::Arranging
           && !controller().actsOnWindow() && !session.nodes.shown() && session.selectionBounds();
}

bool ObjectCapsule::followSubject()
{
    const app::ObjectRanges& now = controller().session().selection();
    if (shown_ == now) // in every move of a gesture
        return false;
    shown_ = now;
    return true;
}

void ObjectCapsule::showValues()
{
    const app::Session& session = controller().session();
    setAccessibleName(app::chosenText(session, false));
    if (followStyle_)
        followStyle_();
    const bool isLine = lineWithHandles(session).has_value(), isText = text_->follow();
    times_->setVisible(!isLine && !isText);
    for (const auto& [info, label, field] : numbers_) {
        const bool has = info->key == ofAngle ? form_ == Form::Whole
                                              : !isText && (info->key == ofLength) == isLine;
        field->setVisible(has);
        if (label)
            label->setVisible(has);
        const bool isAngle = info->quantity == app::Quantity::Angle;
        if (has && !field->isBeingTyped())
            field->show(info->value(session, {}).value_or(0),
                        isAngle ? app::Unit::User : session.display().unit,
                        isAngle ? 1 : session.now().page().realMillimetresPerUnit());
    }
}

app::WindowFrame ObjectCapsule::frame() const
{
    return {*controller().session().selectionBounds(), 0};
}

app::CapsuleRoom ObjectCapsule::room() const
{
    const std::vector<QRectF> marks = selectionMarks(controller().bench());
    QRectF box = selectionOnScreen(controller().bench());
    for (const QRectF& mark : marks)
        box |= mark;
    std::vector<QRectF> covered = marks;
    if (controller().session().windowNumber())
        std::ranges::copy(windowMarks(controller(), surface()->font()),
                          std::back_inserter(covered));
    else if (const QRectF offer = offeredHandle(controller().held()); !offer.isEmpty())
        covered.push_back(offer);
    return {.box = box, .covered = std::move(covered)};
}

QColor ObjectCapsule::ringColour() const { return controller().paperLook().selection; }

} // namespace ui

#include "moc_object_capsule.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/window_fields.h"

#include "app/document/window_shape.h"
#include "app/session/window_steps.h"
#include "app/view/ruler.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/unit_box.h"

#include <QGridLayout>
#include <QLabel>

#include <glm/trigonometric.hpp>

namespace ui {

namespace {

enum Field : std::size_t { X, Y, Width, Height, Angle };

clipping::Window edited(const clipping::Window& window, std::size_t field, double length,
                        bool proportional)
{
    clipping::Window next = window;
    const auto size = window.max - window.min;
    const glm::length_t axis = field == X || field == Width ? 0 : 1;
    if (field == X || field == Y) {
        next.min[axis] = length;
        next.max[axis] = length + size[axis];
        return next;
    }
    next.max[axis] = window.min[axis] + length;
    const glm::length_t other = 1 - axis;
    if (proportional && size[axis] > 0)
        next.max[other] = window.min[other] + size[other] * length / size[axis];
    return next;
}

QLabel* labelled(const QString& text, LengthField& field)
{
    auto* label = new QLabel(text);
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setBuddy(&field);
    return label;
}

/// In degrees, counterclockwise; never −0.
double angleOf(const app::WindowFrame& frame) { return 0 - glm::degrees(frame.angle); }

} // namespace

WindowFields::WindowFields(app::Session& session)
    : session_(session), chain_(ratioButton()), unit_(new UnitBox(session))
{
    using Range = LengthField::Range;
    constexpr auto none = LengthField::Suffix::None;
    fields_ = {new LengthField(Text::tr("X"), Range::Any, none),
               new LengthField(Text::tr("Y"), Range::Any, none),
               new LengthField(Text::tr("Width"), Range::NotNegative, none),
               new LengthField(Text::tr("Height"), Range::NotNegative, none),
               new LengthField(Text::tr("Angle"), Range::Any, none)};
    const QStringList labels{Text::tr("X"), Text::tr("Y"), Text::tr("W"), Text::tr("H")};
    auto* grid = new QGridLayout(this);
    grid->setHorizontalSpacing(space::labelToField);
    grid->setVerticalSpacing(6);
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        connect(fields_[i], &LengthField::edited, this,
                [this, i](double number, app::Merging merging) { edit(i, number, merging); });
        connect(fields_[i], &LengthField::entered, this, &WindowFields::entered);
        connect(fields_[i], &LengthField::refused, this, &WindowFields::refused);
        connect(fields_[i], &LengthField::taken, this, &WindowFields::taken);
        fields_[i]->setMinimumWidth(72);
        if (i == Angle)
            continue; // in a row of its own
        const int row = int(i % 2), column = i < Width ? 0 : 2;
        grid->addWidget(labelled(labels[qsizetype(i)], *fields_[i]), row, column);
        grid->addWidget(fields_[i], row, column + 1);
    }
    fields_[Angle]->setToolTip(
        Text::tr("Degrees, counterclockwise; a shape other than a rectangle is "
                 "rotated by them"));
    connect(unit_, &UnitBox::done, this, &WindowFields::entered);
    chain_->setObjectName(QStringLiteral("keep-ratio"));
    grid->addWidget(unit_, 0, 4);
    grid->addWidget(chain_, 1, 4, Qt::AlignLeft);
    grid->setColumnStretch(1, 1);
    grid->setColumnStretch(3, 1);
    grid->setContentsMargins(space::dockMargin, 6, space::dockMargin, space::dockMargin);
    connect(&session, &app::Session::previewChanged, this, &WindowFields::follow);
    connect(&session, &app::Session::displayChanged, this, &WindowFields::follow);
    follow();
}

QWidget* WindowFields::makeAngle()
{
    auto* row = new QHBoxLayout;
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(space::labelToField);
    row->addWidget(labelled(Text::tr("∠"), *fields_[Angle]));
    row->addWidget(fields_[Angle]);
    auto* angle = new QWidget;
    angle->setLayout(row);
    return angle;
}

void WindowFields::putAfter(QWidget* before)
{
    for (QWidget* next : std::initializer_list<QWidget*>{fields_[X], fields_[Y], fields_[Width],
                                                         fields_[Height], unit_, chain_}) {
        setTabOrder(before, next);
        before = next;
    }
}

void WindowFields::startTyping() { fields_[X]->setFocus(); }

void WindowFields::follow()
{
    const bool has = session_.windowNumber().has_value();
    chain_->setEnabled(has);
    for (LengthField* field : fields_)
        field->setEnabled(has);
    const app::WindowFrame frame =
        session_.windowFrame().value_or(app::WindowFrame{session_.window()});
    const auto& [min, max] = frame.box;
    const double size = session_.now().page().millimetresPerUnit();
    const app::Unit unit = session_.display().unit;
    const app::Point place = min - app::originOf(session_.now().page(), unit);
    const std::array lengths{place.x, place.y, max.x - min.x, max.y - min.y};
    for (std::size_t i = 0; i < lengths.size(); ++i)
        fields_[i]->show(lengths[i], unit, size);
    fields_[Angle]->show(angleOf(frame), app::Unit::User, 1);
    const QString where =
        frame.angle == 0
            ? Text::tr("The left edge of the window, and its top edge")
            : Text::tr("The top left corner that the window has without its rotation about "
                       "its middle");
    for (const std::size_t i : {X, Y})
        fields_[i]->setToolTip(where);
}

void WindowFields::edit(std::size_t field, double number, app::Merging merging)
{
    if (!session_.windowFrame())
        return;
    if (field == Angle)
        return rotate(number, merging);
    const app::WindowShape& shape = session_.windows().list[*session_.windowNumber()].shape;
    const app::WindowFrame frame = *session_.windowFrame();
    const app::Point origin = app::originOf(session_.now().page(), session_.display().unit);
    const double place = field == X ? origin.x : field == Y ? origin.y : 0;
    const clipping::Window after = edited(frame.box, field, place + number, chain_->isChecked());
    const bool moves = field == X || field == Y;
    if (after != frame.box)
        app::setWindowShape(session_,
                            app::fitted(shape, moves ? app::WindowFrame{after, frame.angle}
                                                     : app::resized(frame, after)),
                            moves ? Text::tr("Move clip window") : Text::tr("Resize clip window"),
                            merging);
}

void WindowFields::rotate(double degrees, app::Merging merging)
{
    const app::WindowShape& shape = session_.windows().list[*session_.windowNumber()].shape;
    const double by = degrees - angleOf(*session_.windowFrame());
    if (by != 0)
        app::setWindowShape(session_, app::rotated(shape, -glm::radians(by)),
                            Text::tr("Rotate clip window"), merging);
}

} // namespace ui

#include "moc_window_fields.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/window_fields.h"

#include "app/session/window_values.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/unit_box.h"

#include <QGridLayout>
#include <QLabel>

namespace ui {

namespace {

constexpr int leastNumberRoom = 54; // pixels

QLabel* labelled(const QString& text, LengthField& field)
{
    auto* label = new QLabel(text);
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setBuddy(&field);
    return label;
}

} // namespace

WindowFields::WindowFields(app::Session& session)
    : session_(session), chain_(ratioButton()), unit_(new UnitBox(session))
{
    using enum app::WindowValue;
    using Range = LengthField::Range;
    constexpr auto none = LengthField::Suffix::None;
    fields_ = {new LengthField(Text::tr("X"), Range::Any, none),
               new LengthField(Text::tr("Y"), Range::Any, none),
               new LengthField(Text::tr("Width"), Range::NotNegative, none),
               new LengthField(Text::tr("Height"), Range::NotNegative, none),
               new LengthField(Text::tr("Angle"), Range::Any, none)};
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        connect(fields_[i], &LengthField::edited, this,
                [this, i](double number, app::Merging merging) {
                    app::setWindowValue(session_, app::WindowValue(i), number, chain_->isChecked(),
                                        merging);
                });
        connect(fields_[i], &LengthField::entered, this, &WindowFields::entered);
        connect(fields_[i], &LengthField::refused, this, &WindowFields::refused);
        connect(fields_[i], &LengthField::taken, this, &WindowFields::taken);
        fields_[i]->setMinimumWidth(leastNumberRoom);
    }
    field(Angle).setToolTip(Text::tr("Degrees, counterclockwise; a shape other than a rectangle is "
                                     "rotated by them"));
    connect(unit_, &UnitBox::done, this, &WindowFields::entered);
    chain_->setObjectName(QStringLiteral("keep-ratio"));
    addRows();
    connect(&session, &app::Session::previewChanged, this, &WindowFields::follow);
    connect(&session, &app::Session::displayChanged, this, &WindowFields::follow);
    follow();
}

/// Angle, X and Y; below, width and height with the unit. Tab goes in this order, so that the four
/// lengths follow each other.
void WindowFields::addRows()
{
    struct Place {
        app::WindowValue value;
        const char* label;
        int row, column;
    };
    using enum app::WindowValue;
    constexpr std::array places{Place{X, "X", 0, 2}, Place{Y, "Y", 0, 4}, Place{Width, "W", 1, 0},
                                Place{Height, "H", 1, 2}, Place{Angle, "∠", 0, 0}};
    auto* grid = new QGridLayout(this);
    grid->setHorizontalSpacing(space::labelToField);
    grid->setVerticalSpacing(6);
    for (const auto& [value, label, row, column] : places) {
        grid->addWidget(labelled(QString::fromUtf8(label), field(value)), row, column);
        grid->addWidget(&field(value), row, column + 1);
    }
    auto* end = new QHBoxLayout;
    end->setSpacing(space::labelToField);
    end->addWidget(unit_);
    end->addWidget(chain_);
    end->addStretch();
    grid->addLayout(end, 1, 4, 1, 2);
    for (const int column : {1, 3, 5})
        grid->setColumnStretch(column, 1);
    grid->setContentsMargins(space::dockMargin, 6, space::dockMargin, space::dockMargin);
    QWidget* before = &field(Angle);
    for (QWidget* next : std::initializer_list<QWidget*>{&field(X), &field(Y), &field(Width),
                                                         &field(Height), unit_, chain_}) {
        setTabOrder(before, next);
        before = next;
    }
}

void WindowFields::startTyping() { field(app::WindowValue::X).setFocus(); }

void WindowFields::follow()
{
    using enum app::WindowValue;
    const bool has = session_.windowNumber().has_value();
    chain_->setEnabled(has);
    for (LengthField* field : fields_)
        field->setEnabled(has);
    const double size = session_.now().page().millimetresPerUnit();
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        const auto which = app::WindowValue(i);
        fields_[i]->show(app::windowValue(session_, which),
                         which == Angle ? app::Unit::User : session_.display().unit,
                         which == Angle ? 1 : size);
    }
    const auto& frame = session_.windowFrame();
    const QString where =
        !frame || frame->angle == 0
            ? Text::tr("The left edge of the window, and its top edge")
            : Text::tr("The top left corner that the window has without its rotation about "
                       "its middle");
    for (const app::WindowValue which : {X, Y})
        field(which).setToolTip(where);
}

} // namespace ui

#include "moc_window_fields.cpp"

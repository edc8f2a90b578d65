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
    const QStringList labels{Text::tr("X"), Text::tr("Y"), Text::tr("W"), Text::tr("H")};
    auto* grid = new QGridLayout(this);
    grid->setHorizontalSpacing(space::labelToField);
    grid->setVerticalSpacing(6);
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        connect(fields_[i], &LengthField::edited, this,
                [this, i](double number, app::Merging merging) {
                    app::setWindowValue(session_, app::WindowValue(i), number, chain_->isChecked(),
                                        merging);
                });
        connect(fields_[i], &LengthField::entered, this, &WindowFields::entered);
        connect(fields_[i], &LengthField::refused, this, &WindowFields::refused);
        connect(fields_[i], &LengthField::taken, this, &WindowFields::taken);
        fields_[i]->setMinimumWidth(72);
        if (app::WindowValue(i) == Angle)
            continue; // in a row of its own
        const int row = int(i % 2), column = app::WindowValue(i) < Width ? 0 : 2;
        grid->addWidget(labelled(labels[qsizetype(i)], *fields_[i]), row, column);
        grid->addWidget(fields_[i], row, column + 1);
    }
    field(Angle).setToolTip(Text::tr("Degrees, counterclockwise; a shape other than a rectangle is "
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
    LengthField& field = this->field(app::WindowValue::Angle);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(space::labelToField);
    row->addWidget(labelled(Text::tr("∠"), field));
    row->addWidget(&field);
    auto* angle = new QWidget;
    angle->setLayout(row);
    return angle;
}

void WindowFields::putAfter(QWidget* before)
{
    using enum app::WindowValue;
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

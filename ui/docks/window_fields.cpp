// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/window_fields.h"

#include "app/session/window_values.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/unit_box.h"

#include <QHBoxLayout>
#include <QLabel>

namespace ui {

namespace {

// Logical pixels. In the narrowest column "−841.25" fits into each of three fields.
constexpr int leastNumberRoom = 54, afterLabel = 3, afterField = 6;

QLabel* labelled(const QString& text, LengthField& field)
{
    auto* label = new QLabel(text);
    label->setForegroundRole(QPalette::PlaceholderText);
    label->setBuddy(&field);
    return label;
}

} // namespace

WindowFields::WindowFields(app::Session& session)
    : session_(session), size_(new QWidget), chain_(ratioButton()), unit_(new UnitButton(session))
{
    using enum app::WindowValue;
    using Range = LengthField::Range;
    constexpr auto none = LengthField::Suffix::None;
    fields_ = {new LengthField(Text::tr("X"), Range::Any, none),
               new LengthField(Text::tr("Y"), Range::Any, none),
               new LengthField(Text::tr("Width"), Range::NotNegative, none),
               new LengthField(Text::tr("Height"), Range::NotNegative, none),
               new LengthField(Text::tr("Angle"), Range::Any, LengthField::Suffix::Degrees)};
    for (std::size_t i = 0; i < fields_.size(); ++i) {
        connect(fields_[i], &LengthField::edited, this,
                [this, i](double number, app::Merging merging) {
                    app::setWindowValue(session_, app::WindowValue(i), number, chain_->isChecked(),
                                        merging);
                });
        connect(fields_[i], &LengthField::entered, this, &WindowFields::entered);
        connect(fields_[i], &LengthField::refused, this, &WindowFields::refused);
        connect(fields_[i], &LengthField::taken, this, &WindowFields::taken);
        fields_[i]->setButtonSymbols(QAbstractSpinBox::NoButtons); // arrow keys and wheel do it
        fields_[i]->setMinimumWidth(leastNumberRoom);
    }
    field(Angle).setToolTip(Text::tr("Degrees, counterclockwise; a shape other than a rectangle is "
                                     "rotated by them"));
    chain_->setObjectName(QStringLiteral("keep-ratio"));
    addRows();
    connect(&session, &app::Session::previewChanged, this, &WindowFields::follow);
    connect(&session, &app::Session::displayChanged, this, &WindowFields::follow);
    follow();
}

/// X, Y and angle; below, width and height with the unit. Tab goes in this order.
void WindowFields::addRows()
{
    using enum app::WindowValue;
    const auto row = [this](std::initializer_list<std::pair<const char*, app::WindowValue>> parts) {
        auto* line = new QHBoxLayout;
        line->setSpacing(0);
        for (const auto& [label, value] : parts) {
            line->addSpacing(line->count() == 0 ? 0 : afterField);
            line->addWidget(labelled(QString::fromUtf8(label), field(value)));
            line->addSpacing(afterLabel);
            line->addWidget(&field(value), 1);
        }
        return line;
    };
    auto* size = row({{"W", Width}, {"H", Height}});
    size->addSpacing(afterField);
    size->addWidget(unit_);
    size->addWidget(chain_);
    size->setContentsMargins(0, 0, 0, 0);
    size_->setLayout(size);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(space::dockMargin, 6, space::dockMargin - 4, space::dockMargin);
    column->setSpacing(6);
    column->addLayout(row({{"X", X}, {"Y", Y}, {"∠", Angle}}));
    column->addWidget(size_);
    QWidget* before = &field(X);
    for (QWidget* next : std::initializer_list<QWidget*>{&field(Y), &field(Angle), &field(Width),
                                                         &field(Height), unit_, chain_}) {
        setTabOrder(before, next);
        before = next;
    }
}

void WindowFields::showSize(bool shown) { size_->setVisible(shown); }

void WindowFields::startTyping() { field(app::WindowValue::X).setFocus(); }

void WindowFields::follow()
{
    using enum app::WindowValue;
    const bool has = session_.windowNumber().has_value();
    chain_->setEnabled(has);
    for (LengthField* field : fields_)
        field->setEnabled(has);
    const double size = session_.now().page().realMillimetresPerUnit();
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

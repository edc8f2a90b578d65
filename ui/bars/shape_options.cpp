// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/shape_options.h"

#include "app/drawing/centred_shapes.h"
#include "app/lettering/lettering.h"
#include "ui/canvas/canvas.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/tools/kept_choices.h"
#include "ui/widgets/elements.h"
#include "ui/widgets/font_list.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/look_label.h"
#include "ui/widgets/segments.h"

#include <QCheckBox>
#include <QHBoxLayout>
#include <QLineEdit>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>
#include <array>

namespace ui {

struct ShapeOptions::Option {
    std::string_view shape; ///< the key of its tool, and of the clip window's shape
    QString name;
    std::size_t number; ///< which of the tool's numbers
    Field (ShapeOptions::*make)(const Option& option);
    app::Numbers usual;
    bool ofWindows = true;              ///< also of clip windows of this shape
    QString tip{};                      ///< of a switch
    std::optional<std::size_t> needs{}; ///< the number that must be on for this one
};

std::span<const ShapeOptions::Option> ShapeOptions::options()
{
    using Self = ShapeOptions;
    // THE CATALOGUE. To add something that a tool keeps: add its row.
    static const std::array all{
        Option{"polygon", Text::tr("Sides"), 2, &Self::makeCount, app::usualPolygon()},
        Option{"star", Text::tr("Points"), 2, &Self::makeCount, app::usualStar()},
        Option{"star", Text::tr("Inner radius"), 3, &Self::makePercent, app::usualStar()},
        Option{"rectangle", Text::tr("Corner radius"), 2, &Self::makeLength, {}, false},
        Option{keptLine, Text::tr("Chain lines"), 0, &Self::makeSwitch, usualLine, false,
               Text::tr("From click to click, the next line begins where the last one ends")},
        Option{keptLine, Text::tr("Close at the start"), 1, &Self::makeSwitch, usualLine, false,
               Text::tr("A click where the first line began ends the chain"), 0},
        Option{keptPolyline, Text::tr("Close"), 0, &Self::makeSwitch, usualPolyline, false,
               Text::tr("Enter or Esc closes the polyline when it has three corners or more")},
        Option{"pencil", Text::tr("Tolerance"), 0, &Self::makeTolerance, {}},
        Option{"arc", Text::tr("By", "how an arc is drawn"), 0, &Self::makeArcChoice, {}},
        Option{"text", Text::tr("Font"), 0, &Self::makeFont, {}},
        Option{"text", Text::tr("Size"), 0, &Self::makeTextSize, {app::usualTextSize}}};
    return all;
}

ShapeOptions::ShapeOptions(app::Session& session, Canvas& canvas)
    : session_(session), canvas_(canvas)
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(space::labelToField);
    for (const Option& option : options()) {
        Field field = (this->*option.make)(option);
        field.option = &option;
        if (!qobject_cast<QCheckBox*>(field.field))
            row->addWidget(field.label = quietLabel(option.name));
        row->addWidget(field.field);
        fields_.push_back(std::move(field));
    }
    connect(&canvas, &Canvas::toolChanged, this, &ShapeOptions::follow);
    connect(&canvas, &Canvas::stepsChanged, this, &ShapeOptions::follow); // a shape was drawn
    connect(&canvas, &Canvas::hint, this, &ShapeOptions::follow);         // a key has changed it
    connect(&session, &app::Session::displayChanged, this, &ShapeOptions::follow);
    follow();
}

bool ShapeOptions::offers(const Option& option) const
{
    const bool isWindow = canvas_.tool() == "window";
    return option.shape == (isWindow ? session_.nextWindow : canvas_.tool())
           && (!isWindow || option.ofWindows);
}

bool ShapeOptions::offersSome() const
{
    return std::ranges::any_of(options(), [this](const Option& option) { return offers(option); });
}

LengthField* ShapeOptions::lengthField(const Option& option)
{
    auto* field =
        new LengthField(option.name, LengthField::Range::NotNegative, LengthField::Suffix::Unit);
    new RoomForText(*field, QStringLiteral("000.00 mm"), 28);
    connect(field, &LengthField::entered, this, [this] { canvas_.setFocus(); });
    connect(field, &LengthField::refused, this, &ShapeOptions::refused);
    connect(field, &LengthField::taken, this, &ShapeOptions::taken);
    return field;
}

void ShapeOptions::show(LengthField& field, double length)
{
    field.show(length, session_.display().unit, session_.now().page().realMillimetresPerUnit());
}

ShapeOptions::Field ShapeOptions::makeLength(const Option& option)
{
    LengthField* field = lengthField(option);
    connect(field, &LengthField::edited, this,
            [this, &option](double length) { set(option, length); });
    return {field, [this, field, &option] { show(*field, number(option)); }};
}

/// 0: it is a distance on the screen.
ShapeOptions::Field ShapeOptions::makeTolerance(const Option& option)
{
    Field made = makeLength(option);
    auto* field = static_cast<LengthField*>(made.field);
    field->setToolTip(Text::tr("How far a freehand line may be from where the pointer was. 0: 2 "
                               "pixels."));
    made.show = [this, field, &option] {
        show(*field, number(option));
        if (number(option) > 0)
            return;
        field->showNothing();
        field->findChild<QLineEdit*>()->setPlaceholderText(Text::tr("2 pixels"));
    };
    return made;
}

/// It is kept in millimetres on paper.
ShapeOptions::Field ShapeOptions::makeTextSize(const Option& option)
{
    LengthField* field = lengthField(option);
    field->setToolTip(Text::tr("Height of capital letters of the next text"));
    const auto unit = [this] { return session_.now().page().millimetresPerUnit(); };
    connect(field, &LengthField::edited, this, [this, &option, unit](double length) {
        if (length > 0)
            set(option, length * unit());
        follow();
    });
    return {field, [this, field, &option, unit] {
                const app::Unit onPaper = session_.now().page().paperUnit(session_.display().unit);
                field->show(number(option) / unit(), onPaper, unit());
            }};
}

ShapeOptions::Field ShapeOptions::makeFont(const Option&)
{
    auto* field = new FontList;
    field->setToolTip(Text::tr("Font of the next text"));
    field->setFixedHeight(space::fieldHeight);
    connect(field, &QComboBox::currentIndexChanged, this, [this, field] {
        if (!following_ && !field->font().isEmpty())
            canvas_.keepFont(field->font());
    });
    connect(field, &FontList::done, this, [this] { canvas_.setFocus(); });
    return {field, [this, field] { field->show(canvas_.keptFont()); }};
}

ShapeOptions::Field ShapeOptions::makeArcChoice(const Option& option)
{
    auto* field = new Segments(Text::tr("How the next arc is drawn"),
                               {Text::tr("Three points"), Text::tr("Centre")});
    field->setObjectName(QStringLiteral("arc-by"));
    field->setTips({Text::tr("Through its start, its end and a point (C)"),
                    Text::tr("By its centre, its start and its end (C)")});
    connect(field, &Segments::picked, this, [this, &option](int index) {
        set(option, index);
        canvas_.setFocus();
    });
    return {field, [this, field, &option] { field->choose(number(option) != 0); }};
}

ShapeOptions::Field ShapeOptions::makeCount(const Option& option)
{
    return makeSpin(option, int(app::leastCorners), int(app::mostCorners), 1);
}

ShapeOptions::Field ShapeOptions::makePercent(const Option& option)
{
    Field made = makeSpin(option, 1, 100, 100);
    static_cast<QSpinBox*>(made.field)->setSuffix(QStringLiteral(" %"));
    return made;
}

ShapeOptions::Field ShapeOptions::makeSwitch(const Option& option)
{
    auto* field = new QCheckBox(option.name);
    field->setToolTip(option.tip);
    connect(field, &QCheckBox::clicked, this, [this, &option](bool on) {
        set(option, on ? 1 : 0);
        follow();
        canvas_.setFocus();
    });
    return {field, [this, field, &option] {
                const app::Numbers kept = canvas_.keptNumbers(option.shape).value_or(option.usual);
                field->setChecked(kept[option.number] != 0);
                field->setEnabled(!option.needs || kept[*option.needs] != 0);
            }};
}

/// Shows so many parts of 1.
ShapeOptions::Field ShapeOptions::makeSpin(const Option& option, int least, int most, double parts)
{
    auto* field = new QSpinBox;
    field->setAccessibleName(option.name);
    field->setKeyboardTracking(false);
    field->setRange(least, most);
    field->setFixedHeight(space::fieldHeight);
    new RoomForText(*field, QStringLiteral("0000 %"), 28);
    connect(field, &QSpinBox::valueChanged, this,
            [this, &option, parts](int value) { set(option, value / parts); });
    connect(field, &QSpinBox::editingFinished, this, [this, field] {
        if (field->hasFocus()) // Enter, not Tab
            canvas_.setFocus();
    });
    return {field, [this, field, &option, parts] {
                const QSignalBlocker quiet(field);
                field->setValue(qRound(parts * number(option)));
            }};
}

double ShapeOptions::number(const Option& option) const
{
    return canvas_.keptNumbers(option.shape).value_or(option.usual)[option.number];
}

void ShapeOptions::set(const Option& option, double number)
{
    app::Numbers numbers = canvas_.keptNumbers(option.shape).value_or(option.usual);
    numbers[option.number] = number;
    canvas_.keepNumbers(option.shape, numbers);
}

void ShapeOptions::follow()
{
    const QScopedValueRollback guard(following_, true);
    for (const Field& each : fields_) {
        const bool isShown = offers(*each.option);
        if (each.label)
            each.label->setVisible(isShown);
        each.field->setVisible(isShown);
        if (isShown && (!each.field->hasFocus() || !each.label)) // nothing is being typed
            each.show();
    }
    layout()->invalidate(); // or its size is that of before, until events are handled
}

} // namespace ui

#include "moc_shape_options.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/shape_options.h"

#include "app/drawing/centred_shapes.h"
#include "ui/canvas/canvas.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/elements.h"
#include "ui/widgets/length_field.h"
#include "ui/widgets/look_label.h"

#include <QHBoxLayout>
#include <QSignalBlocker>
#include <QSpinBox>

#include <algorithm>
#include <array>

namespace ui {

struct ShapeOptions::Option {
    enum class Kind : std::uint8_t { Count, Percent, Length };
    std::string_view shape; ///< the key of its tool, and of the clip window's shape
    QString name;
    std::size_t number; ///< which of the tool's numbers
    Kind kind;
    app::Numbers usual;
    bool ofWindows = true; ///< also of clip windows of this shape
};

std::span<const ShapeOptions::Option> ShapeOptions::options()
{
    using enum Option::Kind;
    // THE CATALOGUE. To add a number that a tool keeps: add its row.
    static const std::array all{
        Option{"polygon", Text::tr("Sides"), 2, Count, app::usualPolygon()},
        Option{"star", Text::tr("Points"), 2, Count, app::usualStar()},
        Option{"star", Text::tr("Inner radius"), 3, Percent, app::usualStar()},
        Option{"rectangle", Text::tr("Corner radius"), 2, Length, {}, false}};
    return all;
}

ShapeOptions::ShapeOptions(app::Session& session, Canvas& canvas)
    : session_(session), canvas_(canvas)
{
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(space::labelToField);
    for (const Option& option : options()) {
        QWidget* label = quietLabel(option.name);
        fields_.push_back({&option, label, makeField(option)});
        row->addWidget(label);
        row->addWidget(fields_.back().field);
    }
    connect(&canvas, &Canvas::toolChanged, this, &ShapeOptions::follow);
    connect(&canvas, &Canvas::stepsChanged, this, &ShapeOptions::follow); // a shape was drawn
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

QWidget* ShapeOptions::makeField(const Option& option)
{
    if (option.kind == Option::Kind::Length) {
        auto* field = new LengthField(option.name, LengthField::Range::NotNegative,
                                      LengthField::Suffix::Unit);
        new RoomForText(*field, QStringLiteral("000.00 mm"), 28);
        connect(field, &LengthField::edited, this,
                [this, &option](double length) { set(option, length); });
        connect(field, &LengthField::entered, this, [this] { canvas_.setFocus(); });
        connect(field, &LengthField::refused, this, &ShapeOptions::refused);
        connect(field, &LengthField::taken, this, &ShapeOptions::taken);
        return field;
    }
    const bool isPercent = option.kind == Option::Kind::Percent;
    auto* field = new QSpinBox;
    field->setAccessibleName(option.name);
    field->setKeyboardTracking(false);
    if (isPercent) {
        field->setRange(1, 100);
        field->setSuffix(QStringLiteral(" %"));
    } else {
        field->setRange(int(app::leastCorners), int(app::mostCorners));
    }
    field->setFixedHeight(space::fieldHeight);
    new RoomForText(*field, QStringLiteral("0000 %"), 28);
    connect(field, &QSpinBox::valueChanged, this, [this, &option, isPercent](int value) {
        set(option, isPercent ? value / 100.0 : value);
    });
    connect(field, &QSpinBox::editingFinished, this, [this, field] {
        if (field->hasFocus()) // Enter, not Tab
            canvas_.setFocus();
    });
    return field;
}

void ShapeOptions::set(const Option& option, double number)
{
    app::Numbers numbers = canvas_.keptNumbers(option.shape).value_or(option.usual);
    numbers[option.number] = number;
    canvas_.keepNumbers(option.shape, numbers);
}

void ShapeOptions::follow()
{
    for (const auto& [option, label, field] : fields_) {
        const bool isShown = offers(*option);
        label->setVisible(isShown);
        field->setVisible(isShown);
        const double number =
            canvas_.keptNumbers(option->shape).value_or(option->usual)[option->number];
        if (auto* length = qobject_cast<LengthField*>(field)) {
            length->show(number, session_.display().unit,
                         session_.now().page().millimetresPerUnit());
            continue;
        }
        const QSignalBlocker quiet(field);
        const bool isPercent = option->kind == Option::Kind::Percent;
        static_cast<QSpinBox*>(field)->setValue(qRound(isPercent ? 100 * number : number));
    }
    layout()->invalidate(); // or its size is that of before, until events are handled
}

} // namespace ui

#include "moc_shape_options.cpp"

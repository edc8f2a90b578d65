// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/selection_numbers.h"
#include "ui/canvas/capsule.h"

#include <QLabel>

#include <functional>

namespace ui {

class TextRow;
class UnitButton;

/// The own controls of selected objects, with the tool Select: their colours and stroke, width and
/// height (of a single line its length, of texts their font and size), angle, and their menu.
class ObjectCapsule : public Capsule {
    Q_OBJECT

public:
    ObjectCapsule(Controller& controller, QWidget* parent);

    /// The controls of the style, which come first: a room above makes them. `follow` makes them
    /// those of what is selected.
    void setStyle(QWidget& style, std::function<void()> follow);

    void setForm(Form form) override;

protected:
    bool isFor() const override;
    bool followSubject() override;
    void showValues() override;
    app::WindowFrame frame() const override;
    app::CapsuleRoom room() const override;
    QColor ringColour() const override;

private:
    void addNumber(std::string_view key, bool labelled);

    struct Number {
        const app::SelectionNumber* info;
        QLabel* label;
        LengthField* field;
    };
    std::vector<Number> numbers_;
    std::function<void()> followStyle_{};
    TextRow* text_;
    QLabel* times_;
    QWidget* beforeAngle_;
    UnitButton* unit_;
    Form form_ = Form::Whole;
    app::ObjectRanges shown_; ///< whose values it shows
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QWidget>

#include <functional>
#include <vector>

namespace ui {

class Canvas;
class LengthField;

/// What the tool in hand keeps for the next object: sides of a polygon, points and inner radius of
/// a star, corner radius of a rectangle, tolerance of the pencil, how an arc is drawn, font and
/// size of a text, whether lines make a chain and polylines are closed. Also of clip windows of
/// these shapes.
class ShapeOptions : public QWidget {
    Q_OBJECT

public:
    ShapeOptions(app::Session& session, Canvas& canvas);

    bool offersSome() const; ///< for the tool in hand

signals:
    void refused(const QString& sentence); ///< a typed length is not one
    void taken();                          ///< the length is valid again

private:
    struct Option;
    static std::span<const Option> options();
    bool offers(const Option& option) const;
    /// What shows and sets an option.
    struct Field {
        QWidget* field;
        std::function<void()> show; ///< its value
        const Option* option = nullptr;
        QWidget* label = nullptr; ///< null: the field has its name itself
    };
    LengthField* lengthField(const Option& option);
    void show(LengthField& field, double length);
    Field makeLength(const Option& option);
    Field makeTolerance(const Option& option);
    Field makeTextSize(const Option& option);
    Field makeFont(const Option& option);
    Field makeArcChoice(const Option& option);
    Field makeCount(const Option& option);
    Field makePercent(const Option& option);
    Field makeSwitch(const Option& option);
    Field makeSpin(const Option& option, int least, int most, double parts);
    double number(const Option& option) const;
    void set(const Option& option, double number);
    void follow();

    app::Session& session_;
    Canvas& canvas_;
    std::vector<Field> fields_;
    bool following_ = false; ///< shows what is kept: nothing was chosen
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

#include <QWidget>

#include <vector>

namespace ui {

class Canvas;
class LengthField;

/// The numbers of the next shape that the tool in hand keeps: sides of a polygon, points and inner
/// radius of a star, corner radius of a rectangle. Also of clip windows of these shapes.
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
    QWidget* makeField(const Option& option);
    void set(const Option& option, double number);
    void follow();

    app::Session& session_;
    Canvas& canvas_;
    struct Field {
        const Option* option;
        QWidget *label, *field;
    };
    std::vector<Field> fields_;
};

} // namespace ui

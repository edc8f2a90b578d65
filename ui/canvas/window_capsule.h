// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/window_values.h"
#include "ui/canvas/capsule.h"

class QActionGroup;

namespace ui {

class Segments;
class UnitButton;

/// The chosen clip window's own controls: what it does with those above it, its size, and its menu.
/// The side that is kept is that of all windows together, so their panel has it. The capsule is
/// shown while keys are for the window (Controller::actsOnWindow).
class WindowCapsule : public Capsule {
    Q_OBJECT

public:
    WindowCapsule(Controller& controller, QWidget* parent);

    void setForm(Form form) override;

protected:
    bool isFor() const override;
    bool followSubject() override;
    void showValues() override;
    app::WindowFrame frame() const override;
    app::CapsuleRoom room() const override;
    QColor ringColour() const override;

private:
    void showTips();
    QToolButton* makeOperations();
    LengthField* makeSide(app::WindowValue which);
    void setOperation(int operation);
    void set(app::WindowValue which, double length, bool proportional, app::Merging merging);

    Segments* operation_;
    QActionGroup* operationChoice_; ///< of the menu of operations_
    QToolButton* operations_;
    LengthField *width_, *height_;
    UnitButton* unit_;
    struct Shown {
        std::optional<std::size_t> number{};
        QString name{};
        friend bool operator==(const Shown&, const Shown&) = default;
    };
    Shown shown_; ///< the window whose values it shows
};

} // namespace ui

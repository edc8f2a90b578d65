// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/length.h"
#include "app/base/result.h"
#include "app/commands/undo_command.h"

#include <QDoubleSpinBox>

namespace ui {

/// A field for a length in the drawing, shown in the window's unit. The typed text may have a unit
/// ("2in") and may be an expression ("10+5", "3*25mm"). Signals when editing is finished or an
/// arrow is used, not at every key.
class LengthField : public QDoubleSpinBox {
    Q_OBJECT

public:
    enum class Range : std::uint8_t { Any, NotNegative };
    /// Degrees: an angle, shown with its sign.
    enum class Suffix : std::uint8_t { None, Unit, Degrees };

    /// `name` is the accessible name, also used in messages.
    LengthField(const QString& name, Range range, Suffix suffix, QWidget* parent = nullptr);

    /// `length` in user units; emits no signal.
    void show(double length, app::Unit unit, double millimetresPerUnit);
    void showNothing(); ///< an empty field, for what has no such length
    /// An empty field that says "mixed": a typed length is for all. Steps begin at `length`.
    void showMixed(double length, app::Unit unit, double millimetresPerUnit);
    void stepBy(int steps) override;
    bool isBeingTyped() const; ///< it has the keyboard, and its text is not taken yet
    void discardTyped();
    /// While edited() is emitted: whether it was entered with Shift+Enter.
    bool entersWithShift() const { return entersWithShift_; }
    /// The visible text; ends with an ellipsis if the number does not fit completely.
    QString seenText() const;

signals:
    /// `length` in user units. A typed length is an undo step of its own; steps by arrows and the
    /// wheel may merge with the previous one.
    void edited(double length, app::Merging merging);
    void entered(); ///< Enter was pressed and the value is valid: typing is finished
    void refused(const QString& sentence); ///< the text is not a length, or out of range
    void taken();                          ///< the field's value is valid now

protected:
    bool event(QEvent* event) override;
    QValidator::State validate(QString& text, int& position) const override;
    double valueFromText(const QString& text) const override;
    QString textFromValue(double value) const override;
    void showEvent(QShowEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    app::Result<double> typed(const QString& text) const; ///< in the field's unit
    bool takesTyped();
    bool isBlank() const;
    void restore();
    void finishMixed();
    void finish();

    QString name_;
    Range range_;
    Suffix suffix_;
    app::Unit unit_ = app::Unit::Mm;
    double millimetresPerUnit_ = 1;
    double shown_ = 0;
    bool showsNumber_ = true; ///< otherwise the field is empty
    bool entersWithShift_ = false;
    app::Merging merging_ = app::Merging::Never; ///< for the change in progress
};

} // namespace ui

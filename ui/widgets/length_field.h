// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/length.h"
#include "app/base/result.h"
#include "app/commands/undo_command.h"

#include <QDoubleSpinBox>

namespace ui {

/// A field for a length of the drawing, shown in the window's unit. What is typed may have a unit
/// ("2in") and may be an expression ("10+5", "3*25mm"). It answers when editing is finished or an
/// arrow is used, never at every key.
class LengthField : public QDoubleSpinBox {
    Q_OBJECT

public:
    enum class Range : std::uint8_t { Any, NotNegative };
    enum class Suffix : std::uint8_t { None, Unit };

    /// `name` is what it is called to those who do not see its label, and in messages.
    LengthField(const QString& name, Range range, Suffix suffix, QWidget* parent = nullptr);

    /// In user units; sends no signal.
    void show(double length, app::Unit unit, double millimetresPerUnit);
    void stepBy(int steps) override;
    /// Its text, with an ellipsis where there is no room for the whole number.
    QString seenText() const;

signals:
    /// In user units. What is typed is a step of its own; arrows and the wheel may join the last
    /// one.
    void edited(double length, app::Merging merging);
    void entered();                        ///< with Enter, and it fits: typing is over
    void refused(const QString& sentence); ///< what was typed is no length, or out of range
    void taken();                          ///< what is there now is a value that fits

protected:
    bool event(QEvent* event) override;
    QValidator::State validate(QString& text, int& position) const override;
    double valueFromText(const QString& text) const override;
    QString textFromValue(double value) const override;
    void focusOutEvent(QFocusEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;

private:
    app::Result<double> typed(QString text) const; ///< in the field's unit
    bool takesTyped();
    void finish();

    QString name_;
    Range range_;
    app::Unit unit_ = app::Unit::Mm;
    double millimetresPerUnit_ = 1;
    double shown_ = 0;
    app::Merging merging_ = app::Merging::Never; ///< what a change is just now
};

} // namespace ui

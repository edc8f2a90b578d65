// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/length_field.h"

#include "app/view/numbers.h"
#include "ui/look.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>
#include <QSignalBlocker>

#include <cmath>
#include <optional>

namespace ui {

namespace {

constexpr double limit = 1e9;

/// A number as people type it here (locale or C, either minus), with or without a unit.
std::optional<app::Length> typed(QString text, app::Unit unit)
{
    text = text.simplified();
    text.replace(u'\u2212', u'-');
    text.remove(QLocale().groupSeparator());
    text.replace(QLocale().decimalPoint(), QStringLiteral("."));
    auto length = app::parseLength(text.toStdString());
    if (length && length->unit == app::Unit::User)
        length->unit = unit;
    return length;
}

} // namespace

LengthField::LengthField(const QString& name, Range range, Suffix suffix, QWidget* parent)
    : QDoubleSpinBox(parent), name_(name), range_(range)
{
    setAccessibleName(name);
    setAlignment(suffix == Suffix::Unit ? Qt::AlignLeft : Qt::AlignRight);
    setProperty("withUnit", suffix == Suffix::Unit);
    setRange(-limit, limit); // what is refused is said, not silently changed
    setKeyboardTracking(false);
    setCorrectionMode(QAbstractSpinBox::CorrectToPreviousValue);
    setStepType(QAbstractSpinBox::DefaultStepType);
    setFixedHeight(space::fieldHeight);
    connect(this, &QDoubleSpinBox::valueChanged, this, &LengthField::finish);
}

void LengthField::show(double length, app::Unit unit, double millimetresPerUnit)
{
    const QSignalBlocker quiet(this);
    unit_ = unit;
    millimetresPerUnit_ = millimetresPerUnit;
    setDecimals(app::infoOf(unit).decimals);
    setSingleStep(unit == app::Unit::Inch ? 0.125 : unit == app::Unit::Cm ? 0.1 : 1);
    setValue(app::inUnit(length, unit, millimetresPerUnit));
    shown_ = value();
}

void LengthField::finish()
{
    if (value() == shown_)
        return;
    if (range_ == Range::NotNegative && value() < 0) {
        setValue(shown_); // which comes back here and changes nothing
        emit refused(tr("%1 must be at least 0.").arg(name_));
        return;
    }
    shown_ = value();
    emit edited(app::fromUnit(shown_, unit_, millimetresPerUnit_));
}

QValidator::State LengthField::validate(QString& text, int&) const
{
    if (typed(text, unit_))
        return QValidator::Acceptable;
    static const QString allowed = QStringLiteral(" .,+-\u2212\u00a0'\u2019");
    const bool plausible = std::all_of(text.begin(), text.end(), [](QChar c) {
        return c.isDigit() || c.isLetter() || c == u'%' || allowed.contains(c);
    });
    return plausible ? QValidator::Intermediate : QValidator::Invalid;
}

double LengthField::valueFromText(const QString& text) const
{
    const auto length = typed(text, unit_);
    if (!length || length->unit == app::Unit::Percent)
        return shown_;
    const double user = app::fromUnit(length->value, length->unit, millimetresPerUnit_);
    return app::inUnit(user, unit_, millimetresPerUnit_);
}

QString LengthField::textFromValue(double value) const
{
    const QString number = app::numberText(value, decimals());
    if (!property("withUnit").toBool())
        return number;
    const auto suffix = app::infoOf(unit_).suffix;
    return number + u' ' + QLatin1StringView(suffix.data(), qsizetype(suffix.size()));
}

void LengthField::focusOutEvent(QFocusEvent* event)
{
    QDoubleSpinBox::focusOutEvent(event);
    lineEdit()->deselect();
}

void LengthField::keyPressEvent(QKeyEvent* event)
{
    if (event->key() != Qt::Key_Escape) {
        const bool enters = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
        const bool fits = range_ == Range::Any || valueFromText(text()) >= 0;
        QDoubleSpinBox::keyPressEvent(event);
        if (enters && fits)
            emit entered();
        return;
    }
    lineEdit()->setText(textFromValue(value())); // Esc backs out of what was typed
    selectAll();
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/length_field.h"

#include "app/document/expression.h"
#include "app/view/numbers.h"
#include "ui/look.h"

#include <QKeyEvent>
#include <QLineEdit>
#include <QLocale>
#include <QScopedValueRollback>
#include <QSignalBlocker>

#include <cmath>

namespace ui {

namespace {

constexpr double limit = 1e9;

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

/// Numbers as people type them here: locale or C, either minus and other signs of arithmetic.
app::Result<double> LengthField::typed(QString text) const
{
    text = text.simplified();
    text.replace(u'\u2212', u'-').replace(u'\u00d7', u'*').replace(u'\u00f7', u'/');
    text.remove(QLocale().groupSeparator());
    text.replace(QLocale().decimalPoint(), QStringLiteral("."));
    auto length = app::evaluated(text.toStdString(), {unit_, millimetresPerUnit_});
    if (length && std::abs(*length.value) > limit)
        return app::Result<double>::failure(tr("it is too large"));
    return length;
}

/// Whether what stands there can be taken; else says why not and shows the last number.
bool LengthField::takesTyped()
{
    const auto length = typed(text());
    if (length)
        return range_ == Range::Any || *length.value >= 0; // else finish() says so
    const QString refusedText = text().trimmed();
    lineEdit()->setText(textFromValue(value()));
    emit refused(tr("%1: “%2” is no length: %3.").arg(name_, refusedText, length.error));
    return false;
}

void LengthField::stepBy(int steps)
{
    takesTyped();
    const QScopedValueRollback stepping(merging_, app::Merging::WithLast);
    QDoubleSpinBox::stepBy(steps);
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
    emit edited(app::fromUnit(shown_, unit_, millimetresPerUnit_), merging_);
}

QValidator::State LengthField::validate(QString& text, int&) const
{
    if (typed(text))
        return QValidator::Acceptable;
    static const QString allowed =
        QStringLiteral(" .,+-*/()\u2212\u00d7\u00f7\u00a0'\u2019") + QLocale().groupSeparator();
    const bool plausible = std::all_of(text.begin(), text.end(), [](QChar c) {
        return c.isDigit() || c.isLetter() || c == u'%' || allowed.contains(c);
    });
    return plausible ? QValidator::Intermediate : QValidator::Invalid;
}

double LengthField::valueFromText(const QString& text) const
{
    return typed(text).value.value_or(shown_);
}

QString LengthField::textFromValue(double value) const
{
    QString number = app::numberText(value, decimals());
    if (!property("withUnit").toBool())
        return number;
    const auto suffix = app::infoOf(unit_).suffix;
    return number + u' ' + QLatin1StringView(suffix.data(), qsizetype(suffix.size()));
}

void LengthField::focusOutEvent(QFocusEvent* event)
{
    takesTyped();
    QDoubleSpinBox::focusOutEvent(event);
    lineEdit()->deselect();
}

void LengthField::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape && text() == textFromValue(value()))
        return event->ignore(); // out of the field
    if (event->key() == Qt::Key_Escape) {
        lineEdit()->setText(textFromValue(value())); // Esc backs out of what was typed
        return selectAll();
    }
    const bool enters = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    const bool fits = !enters || takesTyped();
    QDoubleSpinBox::keyPressEvent(event);
    if (enters && fits)
        emit entered();
}

} // namespace ui

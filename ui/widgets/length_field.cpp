// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/widgets/length_field.h"

#include "app/base/number.h"
#include "app/base/numbers.h"
#include "ui/look/look.h"
#include "ui/look/text.h"

#include <QHelpEvent>
#include <QLineEdit>
#include <QLocale>
#include <QPainter>
#include <QScopedValueRollback>
#include <QSignalBlocker>
#include <QToolTip>

#include <cmath>
#include <limits>

namespace ui {

namespace {

constexpr double limit = 1e9;
constexpr QChar degreeSign = u'°';
constexpr int keptDecimals = 12; // of a typed number; fewer are shown

/// If a number does not fit, shows its beginning with an ellipsis, because a cut number would look
/// like another number. Scrolls while it has the focus.
class NumberEdit : public QLineEdit {
public:
    QString seen() const
    {
        return hasFocus() ? text() : fontMetrics().elidedText(text(), Qt::ElideRight, room());
    }

protected:
    void paintEvent(QPaintEvent* event) override
    {
        if (seen() == text())
            return QLineEdit::paintEvent(event);
        QPainter painter(this);
        painter.setPen(palette().color(QPalette::Text));
        painter.drawText(rect().adjusted(margin, 0, -margin, 0),
                         int(alignment()) | Qt::AlignVCenter, seen());
    }

private:
    static constexpr int margin = 2; // QLineEdit's own
    int room() const { return width() - 2 * margin; }
};

double stepOf(app::Unit unit)
{
    using app::Unit;
    return unit == Unit::Inch || unit == Unit::Foot  ? 0.125
           : unit == Unit::Cm || unit == Unit::Metre ? 0.1
                                                     : 1;
}

} // namespace

LengthField::LengthField(const QString& name, Range range, Suffix suffix, QWidget* parent)
    : QDoubleSpinBox(parent), name_(name), range_(range), suffix_(suffix)
{
    setAccessibleName(name);
    setLineEdit(new NumberEdit);
    setAlignment(suffix == Suffix::Unit ? Qt::AlignLeft : Qt::AlignRight);
    setRange(-limit, limit); // refused values are reported, not silently changed
    setKeyboardTracking(false);
    setCorrectionMode(QAbstractSpinBox::CorrectToPreviousValue);
    setStepType(QAbstractSpinBox::DefaultStepType);
    setFixedHeight(space::fieldHeight);
    connect(this, &QDoubleSpinBox::valueChanged, this, &LengthField::finish);
}

/// Parses numbers in the locale's or the C format, with either minus sign and other arithmetic
/// signs.
app::Result<double> LengthField::typed(const QString& text) const
{
    QString number = text;
    if (suffix_ == Suffix::Degrees)
        number.remove(degreeSign);
    auto length = app::typedLength(number, {unit_, millimetresPerUnit_});
    if (length && std::abs(*length.value) > limit)
        return app::Result<double>::failure(Text::tr("it is too large"));
    return length;
}

/// Whether the typed text is valid; if not, says why and restores the last number.
bool LengthField::takesTyped()
{
    if (isBlank())
        return false;
    const auto length = typed(text());
    if (length) {
        const bool fits = range_ == Range::Any || *length.value >= 0; // if not, finish() says so
        if (fits && lineEdit()->isModified())
            emit taken();
        return fits;
    }
    const QString refusedText = text().trimmed(), quoted = Text::tr("“%1”").arg(refusedText);
    restore();
    emit refused(length.error.contains(quoted) // the text is not quoted twice
                     ? Text::tr("%1: %2.").arg(name_, length.error)
                     : Text::tr("%1: %2 is not a length: %3.").arg(name_, quoted, length.error));
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
    setDecimals(keptDecimals);
    setSingleStep(stepOf(unit));
    setValue(app::inUnit(length, unit, millimetresPerUnit));
    shown_ = value();
    showsNumber_ = true;
    lineEdit()->setPlaceholderText({});
}

void LengthField::showNothing()
{
    const QSignalBlocker quiet(this);
    showsNumber_ = false;
    lineEdit()->setText({});
}

/// Discards what was typed. A mixed field shows no number: none of its lengths is for all.
void LengthField::restore()
{
    if (showsNumber_)
        lineEdit()->setText(textFromValue(value()));
    else
        showNothing();
}

void LengthField::showMixed(double length, app::Unit unit, double millimetresPerUnit)
{
    show(length, unit, millimetresPerUnit);
    showNothing();
    shown_ = std::numeric_limits<double>::quiet_NaN(); // whatever is typed is a change
    lineEdit()->setPlaceholderText(Text::tr("mixed"));
}

bool LengthField::isBeingTyped() const { return hasFocus() && lineEdit()->isModified(); }

void LengthField::discardTyped() { restore(); }

QString LengthField::seenText() const { return static_cast<NumberEdit*>(lineEdit())->seen(); }

/// The tooltip shows the whole text if it is elided.
bool LengthField::event(QEvent* event)
{
    if (event->type() == QEvent::ToolTip && seenText() != text()) {
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), text(), this);
        return true;
    }
    return QDoubleSpinBox::event(event);
}

/// Nothing is shown, and nothing was typed.
bool LengthField::isBlank() const
{
    return text().isEmpty() && (std::isnan(shown_) || !lineEdit()->isModified());
}

/// Qt does not signal a typed number that equals the one at which steps begin.
void LengthField::finishMixed()
{
    if (std::isnan(shown_) && !text().isEmpty())
        finish();
}

void LengthField::finish()
{
    if (value() == shown_)
        return;
    if (range_ == Range::NotNegative && value() < 0) {
        if (std::isnan(shown_))
            showNothing();
        else
            setValue(shown_); // calls this function again, without effect
        emit refused(Text::tr("%1 must be at least 0.").arg(name_));
        return;
    }
    shown_ = value();
    showsNumber_ = true;
    emit taken();
    emit edited(app::fromUnit(shown_, unit_, millimetresPerUnit_), merging_);
}

QValidator::State LengthField::validate(QString& text, int&) const
{
    if (typed(text))
        return QValidator::Acceptable;
    static const QString allowed =
        QStringLiteral(" .,+-*/()\u2212\u00d7\u00f7\u00a0'\u2019") + QLocale().groupSeparator();
    const bool plausible = std::all_of(text.begin(), text.end(), [](QChar c) {
        return c.isDigit() || c.isLetter() || c == u'%' || c == degreeSign || allowed.contains(c);
    });
    return plausible ? QValidator::Intermediate : QValidator::Invalid;
}

double LengthField::valueFromText(const QString& text) const
{
    if (text == textFromValue(value())) // the text shows fewer decimals
        return value();
    return typed(text).value.value_or(shown_);
}

QString LengthField::textFromValue(double value) const
{
    const QString number = app::numberText(value, app::infoOf(unit_).decimals);
    if (suffix_ == Suffix::None)
        return number;
    if (suffix_ == Suffix::Degrees)
        return number + degreeSign;
    const auto suffix = app::infoOf(unit_).suffix;
    return number + u' ' + QLatin1StringView(suffix.data(), qsizetype(suffix.size()));
}

void LengthField::showEvent(QShowEvent* event)
{
    const bool blank = isBlank();
    QDoubleSpinBox::showEvent(event);
    if (blank)
        showNothing(); // Qt shows the last number
}

void LengthField::focusOutEvent(QFocusEvent* event)
{
    const bool fits = takesTyped() && lineEdit()->isModified(), blank = isBlank();
    QDoubleSpinBox::focusOutEvent(event);
    if (blank)
        showNothing(); // Qt shows the last number
    else if (fits)
        finishMixed();
    lineEdit()->deselect();
}

void LengthField::keyPressEvent(QKeyEvent* event)
{
    if (event->key() == Qt::Key_Escape) {
        const QString before = text();
        restore();
        if (text() == before)
            return event->ignore(); // Esc leaves the field
        return selectAll();
    }
    const bool enters = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    const QScopedValueRollback shift(entersWithShift_,
                                     enters && event->modifiers() & Qt::ShiftModifier);
    if (enters && isBlank())
        return emit entered(); // Qt would show the last number
    const bool isLength = bool(typed(text()));
    const bool fits = !enters || takesTyped();
    if (!fits)
        event->accept();    // a dialog must not close with the old number
    if (!fits && !isLength) // Qt would show the last number in a mixed field
        return selectAll();
    const bool types = lineEdit()->isModified();
    if (enters && fits)
        emit taken(); // first: its user may refuse the number
    QDoubleSpinBox::keyPressEvent(event);
    if (!fits)
        event->accept();
    if (enters && fits) {
        if (types)
            finishMixed();
        emit entered();
    }
}

} // namespace ui

#include "moc_length_field.cpp"

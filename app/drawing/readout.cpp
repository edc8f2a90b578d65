// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/readout.h"

#include "app/base/numbers.h"
#include "app/document/direction.h"

#include <QCoreApplication>

#include <algorithm>

namespace app {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("Readout", text); }

} // namespace

QString Readout::number(std::size_t field, const Point& end) const
{
    const double value =
        held_[field] ? *held_[field] : gauge_.measure->values(gauge_.start, end)[field];
    const Quantity quantity = gauge_.measure->fields[field].quantity;
    if (quantity == Quantity::Angle)
        return tr("%1°").arg(numberText(value, 1));
    if (quantity == Quantity::Factor)
        return tr("%1 %").arg(numberText(value * 100, 1));
    return lengthText(value, gauge_.scale.unit, gauge_.scale.millimetresPerUnit);
}

bool Readout::follow(const Gauge& gauge)
{
    const auto& now = gauge_.measure->fields;
    const auto& next = gauge.measure->fields;
    const auto sameName = [](const auto& a, const auto& b) { return a.name == b.name; };
    if (gauge.start != gauge_.start || gauge.relativeTo != gauge_.relativeTo
        || !std::ranges::equal(now, next, sameName))
        return false;
    gauge_ = gauge;
    return true;
}

void Readout::activate(std::size_t field)
{
    active_ = field;
    error_.clear();
}

Result<Entry> Readout::entry() const
{
    return readEntry(fields_[active_].text, gauge_.measure->fields[active_].quantity, gauge_.scale);
}

void Readout::type(const QString& text)
{
    release();
    fields_[active_].text = text;
    if (text.trimmed().isEmpty())
        return;
    if (const auto typed = entry())
        hold(*typed.value);
    error_.clear(); // typing is not finished
}

void Readout::release()
{
    if (target_ && fields_[active_].state == State::Locked) { // a point was locked as a whole
        fields_ = {};
        held_ = {};
    }
    target_.reset();
    repeat_.reset();
    held_[active_].reset();
    fields_[active_] = {};
    for (std::size_t field = 0; field < fields_.size(); ++field) // typed here as a whole
        if (fields_[field].state == State::Typed && fields_[field].text.isEmpty()) {
            held_[field].reset();
            fields_[field] = {};
        }
    error_.clear();
}

void Readout::releaseTyped()
{
    if (isLocked() && target_)
        return; // a point that was locked as a whole
    for (std::size_t field = 0; field < fields_.size(); ++field)
        if (fields_[field].state != State::Locked) {
            held_[field].reset();
            fields_[field] = {};
        }
    target_.reset();
    repeat_.reset();
    error_.clear();
}

bool Readout::holds() const { return target_ || held_[0] || held_[1]; }

bool Readout::isLocked() const
{
    return std::ranges::any_of(fields_,
                               [](const Field& field) { return field.state == State::Locked; });
}

bool Readout::refuse(const QString& sentence)
{
    error_ = sentence;
    return false;
}

bool Readout::hold(const Entry& entry)
{
    if (const auto* number = std::get_if<NumberEntry>(&entry)) {
        const GestureMeasure::Field& field = gauge_.measure->fields[active_];
        if (std::abs(number->value) > field.most)
            return refuse(
                tr("%1 must be from −%2 to %2.").arg(field.name, numberText(field.most, 0)));
        holdNumber(active_, number->value);
        return true;
    }
    if (const auto* repeat = std::get_if<RepeatEntry>(&entry)) {
        if (!gauge_.repeats)
            return refuse(tr("There are no copies to repeat here. Type a number."));
        repeat_ = *repeat;
        return true;
    }
    if (gauge_.measure->points == GestureMeasure::Points::Refused)
        return refuse(tr("A point has no meaning here. Type one number."));
    if (const auto* point = std::get_if<PointEntry>(&entry))
        return holdPoint(*point);
    return holdPolar(std::get<PolarEntry>(entry));
}

void Readout::holdNumber(std::size_t field, double value)
{
    held_[field] = value;
    fields_[field].state = State::Typed;
}

bool Readout::holdPoint(const PointEntry& entry)
{
    const bool relative = entry.origin == PointEntry::Origin::Relative
                          || (entry.origin == PointEntry::Origin::Usual
                              && gauge_.measure->points == GestureMeasure::Points::Relative);
    target_ =
        entry.point + (relative ? gauge_.relativeTo.value_or(gauge_.start.from) : gauge_.origin);
    return true;
}

bool Readout::holdPolar(const PolarEntry& entry)
{
    const auto& fields = gauge_.measure->fields;
    const bool hasAngle = fields.size() > 1 && fields[1].quantity == Quantity::Angle;
    if (!entry.length && !hasAngle)
        return refuse(tr("An angle alone has no meaning here. Type a length before it: 30<45."));
    if (!hasAngle) {
        target_ = gauge_.relativeTo.value_or(gauge_.start.from)
                  + directionOf(entry.angle) * *entry.length;
        return true;
    }
    if (entry.length)
        holdNumber(0, *entry.length);
    holdNumber(1, entry.angle);
    return true;
}

bool Readout::lock()
{
    if (!take())
        return false;
    const Quantity quantity = gauge_.measure->fields[active_].quantity;
    if (held_[active_] == 0 && (quantity == Quantity::Length || quantity == Quantity::Factor))
        return refuseZero(active_);
    for (Field& field : fields_)
        if (target_ || field.state == State::Typed)
            field = {State::Locked, {}};
    fields_[active_].text.clear();
    if (gauge_.measure->fields.size() == 1)
        return true;
    const bool onlyOther = fields_[1 - active_].state == State::Locked
                           && fields_[active_].state == State::Free; // "<45"
    activate(onlyOther ? active_ : 1 - active_);
    return true;
}

bool Readout::accept(const Point& pointer)
{
    if (!take())
        return false;
    const auto zero = firstZero(*gauge_.measure, gauge_.start, end(pointer));
    return !zero || refuseZero(*zero);
}

/// Holds what is typed in the active field.
bool Readout::take()
{
    error_.clear();
    if (fields_[active_].text.trimmed().isEmpty())
        return true;
    const auto typed = entry();
    return typed ? hold(*typed.value) : refuse(typed.error);
}

bool Readout::refuseZero(std::size_t field)
{
    return refuse(tr("%1 must not be 0.").arg(gauge_.measure->fields[field].name));
}

Point Readout::end(const Point& pointer) const
{
    if (target_)
        return *target_;
    if (!gauge_.aim)
        return gauge_.measure->end(gauge_.start, pointer + gauge_.shift, held_);
    if (!holds())
        return gauge_.aim->point;
    Held held = held_; // what is not typed stays as it was
    for (std::size_t field = 0; field < held.size(); ++field)
        if (!held[field] && !gauge_.measure->equal)
            held[field] = gauge_.aim->numbers[field];
    return gauge_.measure->end(gauge_.start, gauge_.aim->point, held);
}

GestureEnd Readout::result(const Point& pointer) const
{
    GestureEnd result{end(pointer), {}, repeat_};
    result.numbers = gauge_.aim && !holds() ? gauge_.aim->numbers
                                            : gauge_.measure->values(gauge_.start, result.point);
    for (std::size_t field = 0; field < held_.size() && !target_; ++field)
        result.numbers[field] = held_[field].value_or(result.numbers[field]);
    return result;
}

Point Readout::toStep(const Point& pointer) const
{
    return gauge_.measure->toStep
               ? gauge_.measure->toStep(gauge_.start, pointer + gauge_.shift) - gauge_.shift
               : pointer;
}

} // namespace app

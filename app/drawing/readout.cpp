// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/drawing/readout.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/document/direction.h"

#include <algorithm>
#include <cmath>

namespace app {
QString Readout::number(std::size_t field, const Point& end) const
{
    const double value = valueOf(field, end);
    const Quantity quantity = gauge_.measure->fields[field].quantity;
    if (quantity == Quantity::Angle)
        return Text::tr("%1°").arg(numberText(value, 1));
    if (quantity == Quantity::Factor || quantity == Quantity::Share)
        return Text::tr("%1 %").arg(numberText(value * 100, 1));
    if (quantity == Quantity::Count)
        return numberText(value, 0);
    if (!std::isfinite(value))
        return Text::tr("∞");
    return lengthText(value, gauge_.scale.unit, gauge_.scale.millimetresPerUnit);
}

double Readout::valueOf(std::size_t field, const Point& end) const
{
    if (held_[field])
        return *held_[field];
    return gauge_.measure->fields[field].kept ? gauge_.kept[field]
                                              : gauge_.measure->values(gauge_.start, end)[field];
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
    const bool other = gauge_.measure->fields[active_].kept && isLocked();
    if (target_ && fields_[active_].state == State::Locked) { // a point was locked as a whole
        fields_ = {};
        held_ = {};
    }
    if (!other)
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

bool Readout::typesPoint() const
{
    const auto typed = entry();
    const auto* point = typed ? std::get_if<PointEntry>(&*typed.value) : nullptr;
    return point && point->origin == PointEntry::Origin::Usual;
}

bool Readout::typesDirection() const
{
    const auto typed = entry();
    const auto* polar = typed ? std::get_if<PolarEntry>(&*typed.value) : nullptr;
    return polar && !polar->length && held_[1] && !held_[0];
}

bool Readout::holds() const
{
    return target_
           || std::ranges::any_of(held_, [](const auto& number) { return number.has_value(); });
}

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
    if (const auto* number = std::get_if<NumberEntry>(&entry))
        return hold(number->value);
    if (const auto* repeat = std::get_if<RepeatEntry>(&entry)) {
        if (!gauge_.repeats)
            return refuse(Text::tr("There are no copies to repeat here. Type a number."));
        repeat_ = *repeat;
        return true;
    }
    if (gauge_.measure->points == GestureMeasure::Points::Refused)
        return refuse(Text::tr("A point has no meaning here. Type one number."));
    if (const auto* point = std::get_if<PointEntry>(&entry))
        return holdPoint(*point);
    return holdPolar(std::get<PolarEntry>(entry));
}

bool Readout::hold(double number)
{
    const GestureMeasure::Field& field = gauge_.measure->fields[active_];
    if (std::abs(number) > field.most)
        return refuse(
            Text::tr("%1 must be from −%2 to %2.").arg(field.name, numberText(field.most, 0)));
    if (const auto other = decider())
        return refuse(Text::tr("%1 is locked and determines this number. Unlock it first.")
                          .arg(gauge_.measure->fields[*other].name));
    if (gauge_.measure->equal && !field.kept)
        for (std::size_t i = 0; i < count(); ++i)
            if (!gauge_.measure->fields[i].kept) {
                held_[i].reset();
                fields_[i].state = State::Free;
            }
    holdNumber(active_, number);
    return true;
}

std::optional<std::size_t> Readout::decider() const
{
    const auto& fields = gauge_.measure->fields;
    if (gauge_.measure->equal && !fields[active_].kept)
        for (std::size_t i = 0; i < count(); ++i)
            if (i != active_ && !fields[i].kept && fields_[i].state == State::Locked)
                return i;
    return std::nullopt;
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
        return refuse(
            Text::tr("An angle alone has no meaning here. Type a length before it: 30<45."));
    if (!hasAngle || (entry.length && gauge_.measure->equal)) {
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
    const bool typed = !fields_[active_].text.trimmed().isEmpty();
    if (!take())
        return false;
    const auto& [name, quantity, most, kept] = gauge_.measure->fields[active_];
    if (held_[active_] == 0 && !kept
        && (quantity == Quantity::Length || quantity == Quantity::Factor))
        return refuseZero(active_);
    for (std::size_t i = 0; i < count(); ++i)
        if (fields_[i].state == State::Typed || (target_ && !gauge_.measure->fields[i].kept))
            fields_[i] = {State::Locked, {}};
    fields_[active_].text.clear();
    const bool onlyOthers = fields_[active_].state == State::Free // "<45"
                            && std::ranges::any_of(fields_, [](const Field& field) {
                                   return field.state == State::Locked;
                               });
    if (count() == 1 || (typed && onlyOthers))
        return true;
    std::size_t next = (active_ + 1) % count();
    while (fields_[next].state == State::Locked && next != active_)
        next = (next + 1) % count();
    const bool onlyFree = next == active_ && fields_[active_].state == State::Free;
    activate(next != active_ || onlyFree ? next : (active_ + 1) % count());
    return true;
}

bool Readout::accept(const Point& pointer)
{
    if (!take())
        return false;
    if (gauge_.measure->refusal && !target_)
        if (const QString why = gauge_.measure->refusal(gauge_.start, held_); !why.isEmpty())
            return refuse(why);
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
    return refuse(Text::tr("%1 must not be 0.").arg(gauge_.measure->fields[field].name));
}

Point Readout::end(const Point& pointer) const
{
    if (target_)
        return *target_;
    if (!gauge_.aim)
        return gauge_.measure->end(gauge_.start, pointer + gauge_.shift, held_);
    if (!holds())
        return gauge_.aim->point;
    Held held = held_;
    if (gauge_.alike && held[0].has_value() != held[1].has_value())
        held[held[0] ? 1 : 0] = std::abs(*(held[0] ? held[0] : held[1]));
    // A number that is not typed keeps its value of the aim.
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
    for (std::size_t field = 0; field < count(); ++field)
        if (gauge_.measure->fields[field].kept)
            result.numbers[field] = held_[field].value_or(gauge_.kept[field]);
        else if (held_[field] && !target_)
            result.numbers[field] = *held_[field];
    return result;
}

Point Readout::toStep(const Point& pointer) const
{
    return gauge_.measure->toStep
               ? gauge_.measure->toStep(gauge_.start, pointer + gauge_.shift) - gauge_.shift
               : pointer;
}

} // namespace app

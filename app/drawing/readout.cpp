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
    const double value = gauge_.measure->values(gauge_.from, end)[field];
    if (gauge_.measure->fields[field].quantity == Quantity::Angle)
        return tr("%1°").arg(numberText(value, 1));
    return lengthText(value, gauge_.scale.unit, gauge_.scale.millimetresPerUnit);
}

bool Readout::follow(const Gauge& gauge)
{
    const auto& [one, two] = gauge_.measure->fields;
    const auto& [newOne, newTwo] = gauge.measure->fields;
    if (gauge.from != gauge_.from || newOne.name != one.name || newTwo.name != two.name)
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
    const bool isAngle = gauge_.measure->fields[active_].quantity == Quantity::Angle;
    return readEntry(fields_[active_].text, isAngle, gauge_.scale);
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
    error_.clear();
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

Point Readout::pointOf(const PointEntry& entry) const
{
    const bool relative =
        entry.origin == PointEntry::Origin::Relative
        || (entry.origin == PointEntry::Origin::Usual && gauge_.measure->relative);
    return entry.point + (relative ? gauge_.from : gauge_.origin);
}

bool Readout::hold(const Entry& entry)
{
    const auto holdNumber = [this](std::size_t field, double value) {
        held_[field] = value;
        fields_[field].state = State::Typed;
    };
    if (const auto* number = std::get_if<NumberEntry>(&entry)) {
        holdNumber(active_, number->value);
    } else if (const auto* point = std::get_if<PointEntry>(&entry)) {
        target_ = pointOf(*point);
    } else {
        const auto& polar = std::get<PolarEntry>(entry);
        const bool hasAngle = gauge_.measure->fields[1].quantity == Quantity::Angle;
        if (!polar.length && !hasAngle)
            return refuse(
                tr("An angle alone has no meaning here. Type a length before it: 30<45."));
        if (!hasAngle) {
            target_ = gauge_.from + directionOf(polar.angle) * *polar.length;
        } else {
            if (polar.length)
                holdNumber(0, *polar.length);
            holdNumber(1, polar.angle);
        }
    }
    return true;
}

bool Readout::lock()
{
    if (!take())
        return false;
    if (held_[active_] == 0 && gauge_.measure->fields[active_].quantity == Quantity::Length)
        return refuseZero(active_);
    for (Field& field : fields_)
        if (target_ || field.state == State::Typed)
            field = {State::Locked, {}};
    fields_[active_].text.clear();
    const bool onlyOther = fields_[1 - active_].state == State::Locked
                           && fields_[active_].state == State::Free; // "<45"
    activate(onlyOther ? active_ : 1 - active_);
    return true;
}

bool Readout::accept(const Point& pointer)
{
    if (!take())
        return false;
    const auto zero = firstZeroLength(*gauge_.measure, gauge_.from, end(pointer));
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
    return target_ ? *target_
                   : gauge_.measure->end(gauge_.from, gauge_.aim.value_or(pointer), held_);
}

} // namespace app

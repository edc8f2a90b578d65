// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/sentences/part.h"

#include "app/base/text.h"
#include "app/teaching/sentences/ends.h"
#include "app/teaching/sentences/words.h"

namespace app::words {

using clipping::What;

namespace {

/// Whether an end has to move.
QString needed(const SentenceContext& context, const PartNames& names)
{
    const bool isEnd2 = context.at("end2");
    const char* const name = isEnd2 ? names.stop : names.start;
    const QString value =
        QStringLiteral("%1 = %2").arg(QLatin1StringView(name), knownNumber(context, name));
    if (!context.holds())
        return Text::tr("%1: %2 is inside and stays.").arg(value, end(isEnd2 ? 2 : 1));
    return (isEnd2 ? Text::tr("%1 is less than 1: %2 lies outside and has to move.")
                   : Text::tr("%1 is greater than 0: %2 lies outside and has to move."))
        .arg(value, end(isEnd2 ? 2 : 1));
}

/// Whether only a single point remains of a line whose End 1 has moved.
QString touches(const SentenceContext& context, const PartNames& names)
{
    const QString numbers = knownCompared(context, names.start, names.stop);
    if (context.holds())
        return Text::
            tr("The remaining part begins where it ends (%1): the line only touches the window.")
                .arg(numbers);
    return context.known(names.start) == context.known(names.stop)
               ? Text::tr(
                     "The remaining part begins where it ends (%1), at End 2, which has not moved.")
                     .arg(numbers)
               : Text::tr(
                     "The remaining part begins before it ends (%1): it is more than one point.")
                     .arg(numbers);
}

/// The corrected form clamps an end that no cut has moved to the window.
QString held(const SentenceContext& context, int number)
{
    const bool stays = !context.before || context.before->segment == context.step.segment;
    return (stays ? Text::tr("%1 lies in the window, at %2: it stays where it is.")
                  : Text::tr(
                      "Rounding had left %1 just outside: it is moved into the window, to %2."))
        .arg(end(number), point(endOf(number, context)));
}

} // namespace

QString knownNumber(const SentenceContext& context, const char* name)
{
    return number(context.known(name).value_or(0));
}

QString knownCompared(const SentenceContext& context, const char* one, const char* other)
{
    return compared(context.known(one).value_or(0), context.known(other).value_or(0));
}

QString wholeLine(const SentenceContext& context, const PartNames& names)
{
    QStringList said;
    if (context.value(names.stop))
        said << Text::tr("The whole line remains, from %1 = 0 (End 1) to %2 = 1 (End 2).")
                    .arg(QLatin1StringView(names.start), QLatin1StringView(names.stop));
    const auto way = [&](const char* name) {
        return context.value(name) ? knownNumber(context, name) : QString();
    };
    const QString dx = way("dx"), dy = way("dy");
    if (!dx.isEmpty() && !dy.isEmpty())
        said << Text::tr("From End 1 to End 2, x changes by %1 and y by %2.").arg(dx, dy);
    else if (!dx.isEmpty())
        said << Text::tr("From End 1 to End 2, x changes by %1.").arg(dx);
    else if (!dy.isEmpty())
        said << Text::tr("From End 1 to End 2, y changes by %1.").arg(dy);
    return said.join(u' ');
}

bool isEndOfPart(const SentenceContext& context)
{
    return context.at("end2", "move2", "upright2", "level2", "hold2", "end1", "move1", "upright1",
                      "level1", "touches", "contact", "hold1");
}

QString endsOfPart(const SentenceContext& context, const PartNames& names)
{
    switch (context.step.what) {
    case What::Test:
        return context.at("touches") ? touches(context, names) : needed(context, names);
    case What::Cut:
        return context.at("contact")
                   ? Text::tr("End 1 becomes the same point as End 2, %1.")
                         .arg(point(endOf(1, context)))
                   : moved(context, context.at("move2", "upright2", "level2") ? 2 : 1);
    default:
        return held(context, context.at("hold2") ? 2 : 1);
    }
}

} // namespace app::words

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/window_in_hand.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/session/window_words.h"

#include <glm/trigonometric.hpp>

#include <algorithm>

namespace app {

// The region has a step for each window that has an effect.
const ClipRegion::Step* stepInHand(const Session& session)
{
    const auto number = session.windowNumber();
    if (!number)
        return nullptr;
    const auto numbers = numbersInEffect(session.windows());
    const auto found = std::ranges::lower_bound(numbers, *number);
    if (found == numbers.end() || *found != *number)
        return nullptr;
    return &session.region().steps[std::size_t(found - numbers.begin())];
}

WindowNeeds needsInHand(const Session& session)
{
    const ClipRegion::Step* step = stepInHand(session);
    return step ? needsOf(*step) : WindowNeeds::Rectangle;
}

std::vector<NamedNeeds> needsByName(const Session& session)
{
    std::vector<NamedNeeds> all;
    const auto& steps = session.region().steps;
    for (const std::size_t number : numbersInEffect(session.windows()))
        if (all.size() < steps.size())
            all.push_back({nameOf(session.windows().list[number]), needsOf(steps[all.size()])});
    return all;
}

QString headingInHand(const Session& session)
{
    const ClipRegion::Step* step = stepInHand(session);
    if (!step)
        return {};
    const QString name = session.windows().list[*session.windowNumber()].name;
    return name.isEmpty() ? Text::tr("for a window: %1").arg(shapeText(*step))
                          : Text::tr("for %1: %2").arg(name, shapeText(*step));
}

Variant usedVariant(const Session& session) { return usedAt(session.region(), session.variant()); }

clipping::Segment TracedWindow::into(const clipping::Segment& line) const
{
    return {intoFrame(frame, line.a), intoFrame(frame, line.b)};
}

void TracedWindow::putInto(TracedLine& tracedLine) const
{
    tracedLine.window = frame.box;
    tracedLine.windowIsPage = isPage;
    tracedLine.corners = corners;
}

QString TracedWindow::remark() const
{
    const auto nameOr = [](const QString& name) {
        return name.isEmpty() ? Text::tr("the selected window") : name;
    };
    QStringList said;
    if (among && !notAt)
        said << Text::tr("at %1 alone, of %2 clip windows")
                    .arg(nameOr(among->first))
                    .arg(among->second);
    if (frame.angle != 0) // y grows down, and the angle from x towards y
        said << Text::tr("in the directions of a window rotated by %1°")
                    .arg(numberText(-glm::degrees(frame.angle), 1));
    else if (notAt)
        said << (isPage ? Text::tr("at the page, as %1 is not convex")
                        : Text::tr("at another window, as %1 is not convex"))
                    .arg(nameOr(*notAt));
    return said.join(QStringLiteral(", "));
}

/// At whichever windows there are.
static TracedWindow windowToTrace(const Session& session)
{
    const ComparedWindow& usual = session.compared();
    TracedWindow traced{{usual.window}, usual.isPage};
    const auto number = session.windowNumber();
    if (!number)
        return traced;
    const ClipWindow& inHand = session.windows().list[*number];
    if (const auto* rectangle = std::get_if<RectangleShape>(&inHand.shape))
        return {*rectangle};
    if (const auto* step = stepInHand(session); step && !step->polygon.corners.empty())
        return {.frame = {step->box}, .corners = step->polygon.corners};
    traced.notAt = inHand.name;
    return traced;
}

TracedWindow tracedWindow(const Session& session)
{
    TracedWindow traced = windowToTrace(session);
    const auto number = session.windowNumber();
    const std::size_t windows = session.region().steps.size();
    if (number && windows > 1)
        traced.among = {session.windows().list[*number].name, windows};
    return traced;
}

} // namespace app

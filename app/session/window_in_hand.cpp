// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/window_in_hand.h"

#include "app/base/text.h"

#include <algorithm>

namespace app {

// The region has a step for each visible window.
const ClipRegion::Step* stepInHand(const Session& session)
{
    const auto number = session.windowNumber();
    if (!number)
        return nullptr;
    const auto begin = session.windows().list.begin();
    const auto before = std::count_if(begin, begin + std::ptrdiff_t(*number),
                                      [](const auto& w) { return w.visible; });
    return &session.region().steps[std::size_t(before)];
}

WindowNeeds needsInHand(const Session& session)
{
    const ClipRegion::Step* step = stepInHand(session);
    return step ? needsOf(*step) : WindowNeeds::Rectangle;
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

} // namespace app

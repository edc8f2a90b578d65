// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/comparing.h"

#include "app/base/text.h"
#include "app/comparison/variants.h"
#include "app/scene/window_needs.h"

namespace app {

void setComparing(Session& session, bool comparing)
{
    session.changeDisplay([comparing](Display& display) {
        if (comparing == display.cuts.has_value())
            return;
        if (comparing) {
            display.cuts = display.variant;
        } else {
            display.variant = *display.cuts;
            display.cuts.reset();
        }
    });
}

void useVariant(Session& session, const Variant& variant)
{
    session.changeDisplay([&variant](Display& display) {
        display.variant = variant;
        if (display.cuts)
            display.cuts = variant;
    });
}

QString onlyComparedText(const Session& session)
{
    const Variant shown = usedAt(session.region(), session.variant()),
                  cuts = usedAt(session.region(), session.cuts());
    if (shown == cuts)
        return {};
    return Text::tr("%1 cuts; %2 is only compared", "two algorithms")
        .arg(nameOf(cuts), nameOf(shown));
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/compared_text.h"

#include "app/base/text.h"
#include "app/comparison/at_text.h"
#include "app/session/window_words.h"

namespace app {

QString comparedName(const Session& session)
{
    const auto number = session.compared().number;
    const bool alone = session.region().steps.size() == 1 && session.region().keep == Keep::Inside
                       && session.region().single();
    return number && !alone ? nameOf(session.windows().list[*number]) : QString();
}

QString comparedText(const Session& session)
{
    if (!session.compared().comparable)
        return Text::tr(
            "Nothing is compared: no clip window is a rectangle along the axes. Draw one to "
            "compare there.");
    const QString name = comparedName(session);
    return name.isEmpty() ? atText(session.compared())
                          : Text::tr("Compared inside %1 only.").arg(name);
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/selection_words.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/session/node_numbers.h"
#include "app/session/units.h"

namespace app {

QString selectionText(const Session& session)
{
    if (session.nodes.someSelected())
        return nodesText(session);
    const ObjectRanges& selection = session.selection();
    if (selection.empty())
        return Text::tr("nothing selected");
    const ContainerId group = groupAt(session, selection.first());
    const bool isGroup =
        group != 0 && selection == ObjectRanges(session.now().containers().rangeOf(group));
    const QString count = countText(selection.size());
    return selection.size() == 1 ? isGroup ? Text::tr("group of 1 object") : Text::tr("1 object")
           : isGroup ? Text::tr("group of %1 objects").arg(count)
                                 : Text::tr("%1 objects").arg(count);
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/move_objects.h"

#include "app/base/text.h"

namespace app {

void place(ObjectRow& object, const Placement& where)
{
    object.path = object.path.placed(where);
    if (object.particulars->recipe.index() != 0)
        object.particulars.own().recipe = placed(object.particulars->recipe, where);
}

MoveObjects::MoveObjects(EditedDocument& document, const ObjectRanges& objects, const Point& by,
                         Merging merging)
    : EditCommand(row, document,
                  changed(document.now(), objects,
                          [&](ObjectRow& object, StyleTable&) {
                              place(object, {{1, 1}, by});
                          }),
                  Text::tr("Move selection"), merging, {Derivation::How::Placed, {{1, 1}, by}})
{
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/resize_objects.h"

#include "app/commands/move_objects.h"

#include <QCoreApplication>

namespace app {

Placement fitting(const clipping::Window& from, const clipping::Window& to)
{
    const Point old = from.max - from.min, size = to.max - to.min;
    const Point scale(old.x > 0 ? size.x / old.x : 1, old.y > 0 ? size.y / old.y : 1);
    return {scale, to.min - from.min * scale};
}

ResizeObjects::ResizeObjects(EditedDocument& document, const ObjectRanges& objects,
                             const clipping::Window& from, const clipping::Window& to)
    : EditCommand(row, document,
                  changed(document.now(), objects,
                          [where = fitting(from, to)](ObjectRow& object, StyleTable&) {
                              place(object, where);
                          }),
                  QCoreApplication::translate("Commands", "Resize selection"))
{
}

} // namespace app

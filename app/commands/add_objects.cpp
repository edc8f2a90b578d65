// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/add_objects.h"

namespace app {

AddObjects::AddObjects(EditedDocument& document, const Objects& objects, ContainerId into,
                       const QString& text)
    : EditCommand(row, document, adding(document.now(), objects, into), text)
{
    const std::size_t top = document.now().containers().rangeOf(into).end;
    place_ = {top, top + objects.size()};
}

} // namespace app

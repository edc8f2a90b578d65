// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/add_objects.h"

namespace app {

AddObjects::AddObjects(EditedDocument& document, const Objects& objects, ContainerId into,
                       const QString& text)
    : AddObjects(document, adding(document.now(), objects, into), text)
{
}

AddObjects::AddObjects(EditedDocument& document, Edit adding, const QString& text)
    : EditCommand(row, document, std::move(adding), text)
{
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/add_and_remove.h"

#include "app/base/text.h"

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

namespace {

Edit removed(const Document& document, const ObjectRanges& objects)
{
    Edit edit;
    for (const ObjectRange& range : objects.ranges())
        edit.splices.push_back({std::uint32_t(range.first), std::uint32_t(range.size()), 0});
    edit.containers = document.containers().spliced(edit.splices);
    return edit;
}

} // namespace

RemoveObjects::RemoveObjects(EditedDocument& document, const ObjectRanges& objects,
                             const QString& text)
    : EditCommand(row, document, removed(document.now(), objects), text)
{
}

RemoveObjects::RemoveObjects(EditedDocument& document, const ObjectRanges& objects)
    : RemoveObjects(document, objects, Text::tr("Delete selection"))
{
}

} // namespace app

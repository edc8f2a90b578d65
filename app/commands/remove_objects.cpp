// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/remove_objects.h"

#include "app/base/text.h"

namespace app {
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/set_containers.h"

#include "app/base/text.h"

namespace app {
namespace {

Edit exchanged(Containers containers)
{
    Edit edit;
    edit.containers = std::move(containers);
    return edit;
}

Edit without(const Document& document, ContainerId layer)
{
    const ObjectRange range = document.containers().rangeOf(layer);
    Edit edit = exchanged(document.containers().removed(layer));
    if (!range.empty())
        edit.splices = {{std::uint32_t(range.first), std::uint32_t(range.size()), 0}};
    return edit;
}

} // namespace

SetContainers::SetContainers(EditedDocument& document, Containers containers, const QString& text)
    : EditCommand(row, document, exchanged(std::move(containers)), text)
{
}

RemoveLayer::RemoveLayer(EditedDocument& document, ContainerId layer)
    : EditCommand(row, document, without(document.now(), layer),
                  Text::tr("Remove layer %1").arg(document.now().containers()[layer].name))
{
}

} // namespace app

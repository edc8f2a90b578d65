// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/hidden_objects.h"

#include <algorithm>

namespace app {
namespace {

// Removes the hidden containers, whose objects have already been removed.
Containers withoutHidden(Containers containers)
{
    const auto visible = [&](ContainerId id) { return containers[id].visible; };
    if (std::ranges::none_of(containers.childrenOf(0), visible))
        return Containers(); // a document has at least one layer
    for (const ContainerId id : containers.inOrder())
        if (containers.contains(id) && !visible(id)) // else removed with one around it
            containers = containers.removed(id);
    return containers;
}

} // namespace

ObjectRanges hiddenObjects(const Document& document)
{
    ObjectRanges hidden; // objects that are hidden themselves
    const Objects& objects = document.objects();
    for (std::size_t block = 0; block < objects.blocks().size(); ++block) {
        const auto& marks = objects.blocks()[block]->hidden;
        for (std::size_t i = 0; i < marks.size(); ++i)
            if (marks[i])
                hidden.insert(objects.firstOf(block) + i);
    }
    return united(hidden, document.containers().hiddenRanges());
}

Document withoutHidden(Document document)
{
    const ObjectRanges hidden = hiddenObjects(document);
    Edit edit;
    for (const ObjectRange& range : hidden.ranges())
        edit.splices.push_back({std::uint32_t(range.first), std::uint32_t(range.size()), 0});
    edit.containers = withoutHidden(document.containers().spliced(edit.splices));
    document.apply(edit);
    return document;
}

ObjectRanges editableObjects(const Document& document)
{
    return without(ObjectRanges(ObjectRange{0, document.objects().size()}),
                   united(hiddenObjects(document), document.containers().lockedRanges()));
}

} // namespace app

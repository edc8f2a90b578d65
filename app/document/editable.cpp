// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/editable.h"

namespace app {

// Those that are hidden themselves, whatever is around them.
static ObjectRanges hiddenObjects(const Objects& objects)
{
    ObjectRanges hidden;
    for (std::size_t block = 0; block < objects.blocks().size(); ++block) {
        const ObjectBlock& some = *objects.blocks()[block];
        for (std::size_t i = 0; i < some.hidden.size(); ++i)
            if (some.isHidden(i))
                hidden.insert(objects.firstOf(block) + i);
    }
    return hidden;
}

ObjectRanges editableObjects(const Document& document)
{
    const Containers& containers = document.containers();
    const ObjectRanges others = united(united(containers.hiddenRanges(), containers.lockedRanges()),
                                       hiddenObjects(document.objects()));
    ObjectRanges editable;
    std::size_t next = 0;
    for (const ObjectRange& range : others.ranges()) {
        editable.insert(ObjectRange{next, range.first});
        next = range.end;
    }
    editable.insert(ObjectRange{next, document.objects().size()});
    return editable;
}

} // namespace app

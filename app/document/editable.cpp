// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/editable.h"

#include "app/document/hidden_objects.h"

namespace app {

ObjectRanges editableObjects(const Document& document)
{
    return without(ObjectRanges(ObjectRange{0, document.objects().size()}),
                   united(hiddenObjects(document), document.containers().lockedRanges()));
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/object_in_hand.h"

namespace app {

Edit keeping(const Document& document, const ObjectInHand& inHand)
{
    Objects objects = document.objects().slice(0, 0);
    objects.append(inHand.object);
    if (inHand.replaces && *inHand.replaces < document.objects().size()) {
        Edit edit{.objects = std::move(objects)};
        edit.splices = {{std::uint32_t(*inHand.replaces), 1, 1}};
        return edit;
    }
    const Containers& containers = document.containers();
    const bool known = inHand.into != 0 && containers.contains(inHand.into);
    return adding(document, objects, known ? inHand.into : containers.childrenOf(0).back());
}

} // namespace app

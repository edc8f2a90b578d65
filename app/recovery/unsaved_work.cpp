// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/unsaved_work.h"

#include "app/session/samples.h"

namespace app {

void UnsavedWork::tell(Document document)
{
    const std::lock_guard writing(lock_);
    document_ = std::move(document);
}

bool UnsavedWork::unsaved() const
{
    const std::lock_guard reading(lock_);
    return unsaved(edited_.snapshot());
}

bool UnsavedWork::unsaved(const app::Document& document) const
{
    return document_.inHand
           || (document_.changed && !isUnchangedSample(document_.sample, document));
}

UnsavedWork::Written UnsavedWork::write() const
{
    const std::lock_guard reading(lock_);
    app::Document document = edited_.snapshot();
    if (!unsaved(document))
        return {};
    if (document_.inHand) {
        document = withOwnStyles(document); // keeps the edited document's styles
        Objects objects = document.objects().slice(0, 0);
        objects.append(document_.inHand->object);
        // The layer may have been deleted meanwhile.
        const ContainerId said = document_.inHand->into;
        const ContainerId into = document.containers().contains(said)
                                     ? said
                                     : document.containers().childrenOf(0).back();
        document.apply(adding(document, objects, into));
    }
    return {true, writeLeftover(document, document_.origin, document_.file)};
}

} // namespace app

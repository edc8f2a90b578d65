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
        document.apply(keeping(document, *document_.inHand));
    }
    return {true, writeLeftover(document, document_.origin, document_.file)};
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/unsaved_work.h"

#include "app/document/samples.h"

namespace app {

void UnsavedWork::tell(Document document)
{
    const std::lock_guard writing(lock_);
    document_ = std::move(document);
}

UnsavedWork::Written UnsavedWork::write() const
{
    const std::scoped_lock reading(lock_, drawing_.lock());
    const Sheet& sheet = drawing_.sheet();
    const bool changed = document_.changed && !isOnlyLookedAt(document_.sample, sheet);
    if (!changed && !document_.inHand)
        return {};
    return {true, writeLeftover(sheet, document_.origin, document_.file, document_.inHand)};
}

} // namespace app

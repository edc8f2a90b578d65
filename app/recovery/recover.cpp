// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/recover.h"

#include "app/base/text.h"
#include "app/formats/format.h"
#include "app/recovery/journal_folder.h"
#include "app/recovery/journal_reading.h"

namespace app {

Result<Recovered> recover(const Leftover& leftover)
{
    using Found = Result<Recovered>;
    if (isJournal(leftover.file)) {
        auto found = replayed(leftover.file);
        if (!found)
            found = salvaged(leftover.file);
        if (found)
            return Found::of(std::move(*found));
        return Found::failure(Text::tr("Its journal is damaged at the start."));
    }
    auto read = readFile(leftover.file, &formats().front());
    if (!read)
        return Found::failure(read.error);
    Recovered found;
    found.document = std::move(read.value->document);
    found.history.clean.reset();
    found.origin.origin = leftover.origin;
    return Found::of(std::move(found));
}

} // namespace app

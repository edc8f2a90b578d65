// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/document/document.h"
#include "app/formats/format.h"
#include "app/recovery/journal_folder.h"
#include "app/recovery/journal_reading.h"
#include "app/recovery/log_file.h"
#include "app/session/samples.h"

#include <QFileInfo>

#include <algorithm>

// The last resort: the logs without the drawing from which they continue.

namespace app {
namespace {

// The number of the first record, in the oldest log whose beginning is readable.
struct Start {
    int generation;
    std::uint64_t record;
};

std::optional<Start> startOf(const QString& folder)
{
    for (const int generation : logGenerations(folder))
        if (const auto first = firstRecordOf(contentsOf(logFile(folder, generation))))
            return Start{generation, *first};
    return std::nullopt;
}

// The drawing that was opened, if it can be read as it was.
std::optional<Document> opened(const JournalOrigin& origin)
{
    QString file = origin.origin.path;
    if (!origin.sample.isEmpty()) {
        const auto all = samples();
        const auto sample = std::ranges::find(all, origin.sample, &Sample::key);
        file = sample == all.end() ? QString() : sample->file;
    } else if (!file.isEmpty() && QFileInfo(file).lastModified() != origin.origin.fileTime) {
        return std::nullopt;
    }
    auto read = file.isEmpty() ? Result<Imported>{} : readFile(file);
    return read ? std::optional(std::move(read.value->document)) : std::nullopt;
}

} // namespace

JournalOrigin firstOrigin(const QString& folder)
{
    JournalState state;
    if (const auto start = startOf(folder))
        forEachRecord(folder, start->generation, start->record, [&](std::string_view record) {
            return state.follow(record) && state.index == 0;
        });
    return state.origin;
}

std::optional<Recovered> salvaged(const QString& folder)
{
    const auto start = startOf(folder);
    if (!start)
        return std::nullopt;
    JournalBase base{start->record, 0, firstOrigin(folder), newDrawing(), {}};
    auto original = opened(base.origin);
    if (original)
        base.document = std::move(*original);
    Replay replay(std::move(base));
    const Reach reach =
        forEachRecord(folder, start->generation, start->record,
                      [&](std::string_view record) { return replay.follow(record); });
    Recovered found = replay.take();
    if (found.history.steps.empty())
        return std::nullopt;
    if (!original || !reach.whole)
        found.lost = Text::tr("only some of its steps could be repeated");
    else
        found.lost = Text::tr("it was made from the file and the steps since then");
    return found;
}

} // namespace app

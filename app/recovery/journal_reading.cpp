// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/journal_reading.h"

#include "app/base/text.h"
#include "app/recovery/journal_folder.h"
#include "app/recovery/log_file.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>

namespace app {
namespace {

constexpr qint64 mostHeader = 1 << 20; // bytes; long enough for any path

struct Way {
    Recovered drawing;
    Reach reach;
    bool allSteps; ///< the history of the base is complete
};

std::optional<Way> way(const QString& folder, const BaseFile& file)
{
    auto base = readBase(contentsOf(file.path));
    if (!base)
        return std::nullopt;
    const bool allSteps = !base->lacksSteps;
    const std::uint64_t next = base->firstRecord;
    Replay replay(std::move(*base));
    const Reach reach = forEachRecord(folder, file.generation, next, [&](std::string_view record) {
        return replay.follow(record);
    });
    return Way{replay.take(), reach, allSteps};
}

} // namespace

std::optional<KnownJournal> known(const QString& folder)
{
    for (const BaseFile& file : baseFiles(folder)) {
        auto header = readBaseHeader(contentsOf(file.path, mostHeader));
        if (!header)
            continue;
        const Reach reach =
            forEachRecord(folder, file.generation, header->firstRecord,
                          [&](std::string_view record) { return header->state.follow(record); });
        return KnownJournal{std::move(header->state), !reach.whole};
    }
    return std::nullopt;
}

// The ways meet at the newest log, so a later way never leads farther than an earlier one, but may
// have more steps to undo.
std::optional<Recovered> replayed(const QString& folder)
{
    std::optional<Way> best;
    for (const BaseFile& file : baseFiles(folder)) {
        auto next = way(folder, file);
        if (next && (!best || (next->allSteps && next->reach.end >= best->reach.end)))
            best = std::move(next);
        if (best && best->allSteps)
            break;
    }
    if (!best)
        return std::nullopt;
    if (!best->reach.whole)
        best->drawing.lost = Text::tr("its last steps are missing");
    else if (!best->allSteps)
        best->drawing.lost = Text::tr("its older steps cannot be undone");
    return std::move(best->drawing);
}

bool hasContents(const QString& folder)
{
    return !baseFiles(folder).empty() || !logGenerations(folder).empty();
}

QDateTime lastWritten(const QString& folder)
{
    QDateTime last;
    for (const int generation : logGenerations(folder))
        last = std::max(last, QFileInfo(logFile(folder, generation)).lastModified());
    return last;
}

} // namespace app

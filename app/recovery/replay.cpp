// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/replay.h"

#include "app/base/text.h"
#include "app/commands/add_and_remove.h"
#include "app/commands/change_paths.h"
#include "app/formats/format.h"
#include "app/recovery/journal_folder.h"
#include "app/recovery/journal_reading.h"

namespace app {
namespace {

constexpr std::size_t all = ~std::size_t(0);

} // namespace

Replay::Replay(JournalBase base)
    : document_(std::move(base.document)), firstStep_(base.firstStep),
      origin_(std::move(base.origin))
{
    restore(history_, document_, std::move(base.history));
}

bool Replay::follow(std::string_view record)
{
    ByteReader in(record);
    switch (const RecordKind kind = in.choice(RecordKind::InHand)) {
    case RecordKind::Step:
    case RecordKind::Joined:
        return in.ok() && followStep(in, kind);
    case RecordKind::Index: {
        const auto index = in.get<StepNumber>();
        return in.ok() && followIndex(index);
    }
    case RecordKind::Clean: {
        const auto clean = readClean(in);
        return in.ok() && followClean(clean);
    }
    case RecordKind::Origin: {
        auto origin = readOrigin(in);
        if (in.ok())
            origin_ = std::move(origin);
        return in.ok();
    }
    case RecordKind::InHand:
        return followInHand(in);
    }
    return false;
}

bool Replay::followStep(ByteReader& in, RecordKind kind)
{
    const auto key = in.list<char>();
    const QString text = in.text();
    auto change = readChange(in, now());
    if (!change)
        return false;
    inHand_.reset();
    // The last step's undo takes back both. The base may have left that step out.
    if (kind == RecordKind::Joined)
        document_.apply(change->edit);
    else
        history_.push(new EditCommand(kindOf({key.data(), key.size()}), document_,
                                      std::move(change->edit), text));
    return true;
}

std::optional<int> Replay::indexOf(StepNumber number) const
{
    const StepNumber first = firstStep_ + StepNumber(history_.forgotten());
    if (number < first || number - first > StepNumber(history_.count()))
        return std::nullopt;
    return int(number - first);
}

// The edits of a base are from a file: those that do not fit are not applied.
bool Replay::followIndex(StepNumber number)
{
    const auto index = indexOf(number);
    if (!index)
        return false;
    while (history_.index() != *index) {
        const bool back = history_.index() > *index;
        const int step = back ? history_.index() - 1 : history_.index();
        if (!fits(static_cast<const EditCommand&>(history_.command(step)).next(), now()))
            return false;
        back ? history_.undo() : history_.redo();
    }
    return true;
}

bool Replay::followClean(std::optional<StepNumber> clean)
{
    const auto index = clean ? indexOf(*clean) : std::nullopt;
    history_.resetClean();
    if (index)
        history_.setCleanIndex(*index);
    return true;
}

bool Replay::followInHand(ByteReader& in)
{
    auto object = readInHand(in);
    if (!in.ok() || !in.atEnd())
        return false;
    inHand_ = std::move(object);
    return true;
}

Recovered Replay::take()
{
    if (inHand_) {
        history_.push(new EditCommand(inHand_->replaces ? ChangePaths::row : AddObjects::row,
                                      document_, keeping(now(), *inHand_),
                                      Text::tr("Recover unfinished object")));
        inHand_.reset();
    }
    return {now(), recorded(history_, all), std::move(origin_), {}};
}

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

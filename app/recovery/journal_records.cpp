// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/journal_records.h"

namespace app {
namespace {

ByteWriter started(RecordKind kind, Lending lending = Lending::No)
{
    ByteWriter out = startedFrame(lending);
    out.put(kind);
    return out;
}

} // namespace

ByteWriter startedFrame(Lending lending)
{
    ByteWriter out(lending);
    out.bytes().resize(frameHeader);
    return out;
}

void writeOrigin(ByteWriter& out, const JournalOrigin& origin)
{
    out.put(origin.origin.name);
    out.put(origin.origin.path);
    const QDateTime& time = origin.origin.fileTime;
    out.put(std::uint8_t(time.isValid()));
    out.put(std::int64_t(time.isValid() ? time.toMSecsSinceEpoch() : 0));
    out.put(origin.sample);
}

JournalOrigin readOrigin(ByteReader& in)
{
    JournalOrigin origin;
    origin.origin.name = in.text();
    origin.origin.path = in.text();
    const bool timed = in.flag();
    const auto time = in.get<std::int64_t>();
    if (timed)
        origin.origin.fileTime = QDateTime::fromMSecsSinceEpoch(time);
    origin.sample = in.text();
    return origin;
}

void writeClean(ByteWriter& out, std::optional<StepNumber> clean)
{
    out.put(std::uint8_t(clean.has_value()));
    out.put(clean.value_or(0));
}

std::optional<StepNumber> readClean(ByteReader& in)
{
    const bool some = in.flag();
    const auto clean = in.get<StepNumber>();
    return some && in.ok() ? std::optional(clean) : std::nullopt;
}

Frame stepRecord(const EditCommand& done, const Document& now, bool joined)
{
    ByteWriter out = started(joined ? RecordKind::Joined : RecordKind::Step, Lending::Yes);
    const std::string_view key = done.kind().key;
    out.putList(key);
    out.put(done.text());
    auto written = std::make_shared<const Objects>(writeChange(out, done, now));
    return {std::move(out.bytes()), std::move(out.lent()), std::move(written)};
}

std::string indexRecord(StepNumber index)
{
    ByteWriter out = started(RecordKind::Index);
    out.put(index);
    return std::move(out.bytes());
}

std::string cleanRecord(std::optional<StepNumber> clean)
{
    ByteWriter out = started(RecordKind::Clean);
    writeClean(out, clean);
    return std::move(out.bytes());
}

std::string originRecord(const JournalOrigin& origin)
{
    ByteWriter out = started(RecordKind::Origin);
    writeOrigin(out, origin);
    return std::move(out.bytes());
}

std::string inHandRecord(const std::optional<ObjectInHand>& object)
{
    ByteWriter out = started(RecordKind::InHand);
    out.put(std::uint8_t(object.has_value()));
    if (object) {
        out.put(object->into);
        ObjectBytes().write(out, object->object);
        if (object->replaces)
            out.put(std::uint32_t(*object->replaces));
    }
    return std::move(out.bytes());
}

std::optional<ObjectInHand> readInHand(ByteReader& in)
{
    if (!in.flag())
        return std::nullopt;
    const auto into = in.get<ContainerId>();
    ObjectInHand object({ObjectReader().object(in), into});
    if (!in.atEnd())
        object.replaces = in.get<std::uint32_t>();
    return object;
}

bool JournalState::follow(std::string_view record)
{
    ByteReader in(record);
    switch (in.choice(RecordKind::InHand)) {
    case RecordKind::Step:
        if (clean && *clean > index)
            clean.reset(); // that state was undone and can no longer be redone
        ++index;
        inHand = false;
        break;
    case RecordKind::Joined:
        inHand = false;
        break;
    case RecordKind::Index:
        index = in.get<StepNumber>();
        break;
    case RecordKind::Clean:
        clean = readClean(in);
        break;
    case RecordKind::Origin:
        origin = readOrigin(in);
        break;
    case RecordKind::InHand:
        inHand = in.flag();
        break;
    }
    return in.ok();
}

} // namespace app

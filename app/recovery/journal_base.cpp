// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/journal_base.h"

#include <algorithm>

namespace app {
namespace {

constexpr std::string_view baseMark = "clearcut journal base 9\n";
constexpr std::string_view logMark = "clearcut journal log 9\n";
constexpr std::uint64_t numberOfHeader = ~std::uint64_t(0); // of the frame before a log's records

void append(std::string& bytes, ByteWriter& frame, std::uint64_t number)
{
    sealFrame(frame.bytes(), number);
    bytes += frame.bytes();
}

std::optional<std::string_view> after(std::string_view bytes, std::string_view mark)
{
    return bytes.starts_with(mark) ? std::optional(bytes.substr(mark.size())) : std::nullopt;
}

std::optional<BaseHeader> header(FrameReader& frames)
{
    const auto payload = frames.next();
    if (!payload)
        return std::nullopt;
    ByteReader in(*payload);
    BaseHeader header;
    header.firstRecord = in.get<std::uint64_t>();
    header.firstStep = in.get<StepNumber>();
    header.steps = in.get<std::uint32_t>();
    header.state.index = in.get<StepNumber>();
    header.state.clean = readClean(in);
    header.state.origin = readOrigin(in);
    in.require(header.state.index >= header.firstStep
               && header.state.index - header.firstStep <= header.steps);
    return in.ok() ? std::optional(std::move(header)) : std::nullopt;
}

// All steps, or false.
bool readSteps(FrameReader& frames, std::uint32_t count, ObjectReader& objects,
               const Document& document, RecordedHistory& history)
{
    for (; count > 0; --count) {
        const auto payload = frames.next();
        if (!payload)
            return false;
        ByteReader in(*payload);
        const auto key = in.list<char>();
        const QString text = in.text();
        auto edit = readEdit(in, objects, document.objects());
        if (!edit)
            return false;
        history.steps.push_back({&kindOf({key.data(), key.size()}), text, std::move(*edit)});
    }
    return true;
}

} // namespace

std::string baseBytes(const JournalBase& base)
{
    std::string bytes(baseMark);
    std::uint64_t number = 0;
    ByteWriter header = startedFrame();
    header.put(base.firstRecord);
    header.put(base.firstStep);
    header.putCount(base.history.steps.size());
    header.put(StepNumber(base.firstStep + StepNumber(base.history.index)));
    const auto& clean = base.history.clean;
    writeClean(header, clean ? std::optional(base.firstStep + StepNumber(*clean)) : std::nullopt);
    writeOrigin(header, base.origin);
    append(bytes, header, number++);

    ObjectBytes objects;
    ByteWriter document = startedFrame();
    writeDocument(document, base.document, objects);
    append(bytes, document, number++);
    for (const RecordedHistory::Step& step : base.history.steps) {
        ByteWriter out = startedFrame();
        out.putList(step.kind->key);
        out.put(step.text);
        writeEdit(out, step.next, objects);
        append(bytes, out, number++);
    }
    return bytes;
}

std::optional<BaseHeader> readBaseHeader(std::string_view bytes)
{
    const auto content = after(bytes, baseMark);
    if (!content)
        return std::nullopt;
    FrameReader frames(*content, 0);
    return header(frames);
}

std::optional<JournalBase> readBase(std::string_view bytes)
{
    const auto content = after(bytes, baseMark);
    if (!content)
        return std::nullopt;
    FrameReader frames(*content, 0);
    const auto known = header(frames);
    const auto payload = known ? frames.next() : std::nullopt;
    if (!payload)
        return std::nullopt;
    ByteReader in(*payload);
    ObjectReader objects;
    auto document = readDocument(in, objects);
    if (!document)
        return std::nullopt;
    JournalBase base{
        known->firstRecord, known->firstStep, known->state.origin, std::move(*document), {}, false};
    base.history.index = int(known->state.index - known->firstStep);
    if (const auto clean = known->state.clean; clean && *clean >= known->firstStep)
        base.history.clean = int(*clean - known->firstStep);
    if (!readSteps(frames, known->steps, objects, base.document, base.history)) {
        base.firstStep = known->state.index;
        base.history = {};
        base.lacksSteps = true;
    }
    return base;
}

std::string logHeader(std::uint64_t firstRecord)
{
    std::string bytes(logMark);
    ByteWriter frame = startedFrame();
    frame.put(firstRecord);
    append(bytes, frame, numberOfHeader);
    return bytes;
}

std::optional<std::uint64_t> firstRecordOf(std::string_view log)
{
    const auto content = after(log, logMark);
    const auto payload = content ? FrameReader(*content, numberOfHeader).next() : std::nullopt;
    if (!payload || payload->size() != sizeof(std::uint64_t))
        return std::nullopt;
    return ByteReader(*payload).get<std::uint64_t>();
}

FrameReader recordsOf(std::string_view log, std::uint64_t firstRecord)
{
    constexpr std::size_t header = logMark.size() + frameHeader + sizeof firstRecord;
    return {log.substr(std::min(header, log.size())), firstRecord};
}

} // namespace app

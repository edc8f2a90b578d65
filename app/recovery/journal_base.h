// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/recovery/journal_records.h"
#include "app/recovery/recorded_history.h"

namespace app {

/// The state from which a journal's log continues.
struct JournalBase {
    std::uint64_t firstRecord = 0; ///< the number of the log's next record
    StepNumber firstStep = 0;      ///< the number of the first step in `history`
    JournalOrigin origin{};
    Document document{};
    RecordedHistory history{};
    bool lacksSteps = false; ///< its history was damaged
};

/// The file of a base. May run on any thread.
std::string baseBytes(const JournalBase& base);

/// The state in a base, read without its drawing; empty if the bytes are no base.
struct BaseHeader {
    std::uint64_t firstRecord = 0;
    StepNumber firstStep = 0;
    std::uint32_t steps = 0;
    JournalState state{};
};
std::optional<BaseHeader> readBaseHeader(std::string_view bytes);

/// Empty if the drawing is damaged. Of a damaged history, no step is kept.
std::optional<JournalBase> readBase(std::string_view bytes);

/// The bytes that a log begins with.
std::string logHeader(std::uint64_t firstRecord);
/// The number of its first record; empty if the bytes are no log or begin with damage.
std::optional<std::uint64_t> firstRecordOf(std::string_view log);
/// The records of a log that continues with that number. They are valid only with their right
/// numbers, so that a damaged header does not matter.
FrameReader recordsOf(std::string_view log, std::uint64_t firstRecord);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_in_hand.h"
#include "app/recovery/change_bytes.h"
#include "app/recovery/frames.h"
#include "app/recovery/leftover.h"

#include <QByteArray>

// The records of a journal, one frame each. Numbers of steps count from the start of the history:
// they stay the same when the oldest steps are forgotten.

namespace app {

using StepNumber = std::uint64_t;

enum class RecordKind : std::uint8_t {
    Step,   ///< a new step
    Joined, ///< a change that joined the last step
    Index,  ///< undo, redo: the number of steps that are done
    Clean,  ///< the number of steps at which the document is saved, if any
    Origin, ///< name and path
    InHand  ///< the object being drawn or edited, or that there is none; a step ends it, too
};

/// What a journal is about, apart from the drawing.
struct JournalOrigin {
    Origin origin{};
    QString sample{}; ///< key of the sample that it was opened from; empty: none
    friend bool operator==(const JournalOrigin&, const JournalOrigin&) = default;
};
void writeOrigin(ByteWriter& out, const JournalOrigin& origin);
JournalOrigin readOrigin(ByteReader& in);

// Frames that are not sealed yet.
/// Lends the lines that were added.
Frame stepRecord(const EditCommand& done, const Document& now, bool joined);
std::string indexRecord(StepNumber index);
std::string cleanRecord(std::optional<StepNumber> clean);
std::string originRecord(const JournalOrigin& origin);
std::string inHandRecord(const std::optional<ObjectInHand>& object);
std::optional<ObjectInHand> readInHand(ByteReader& in);

/// Begins a frame: the place of its header.
ByteWriter startedFrame(Lending lending = Lending::No);

/// What can be said of a journal without its drawing.
struct JournalState {
    StepNumber index = 0;
    std::optional<StepNumber> clean{};
    JournalOrigin origin{};
    bool inHand = false;
    bool unsaved() const { return inHand || clean != index; }
    /// Follows a record; false if it is not valid.
    bool follow(std::string_view record);
};

void writeClean(ByteWriter& out, std::optional<StepNumber> clean);
std::optional<StepNumber> readClean(ByteReader& in);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"
#include "app/document/object_in_hand.h"
#include "app/recovery/journal_base.h"

namespace app {

/// A drawing that was recovered, with its history.
struct Recovered {
    Document document{};
    RecordedHistory history{};
    JournalOrigin origin{};
    QString lost{}; ///< what is missing because files are damaged, as a clause; empty: nothing
};

/// Repeats the steps of a journal. One thread.
class Replay {
public:
    explicit Replay(JournalBase base);

    /// Follows the next record; false, and nothing has changed, if it is not valid here.
    bool follow(std::string_view record);
    const Document& now() const { return document_.now(); }
    const History& history() const { return history_; }
    const std::optional<ObjectInHand>& inHand() const { return inHand_; }
    /// The drawing, in which the object in hand is the last step.
    Recovered take();

private:
    bool followStep(ByteReader& in, RecordKind kind);
    bool followIndex(StepNumber index);
    bool followClean(std::optional<StepNumber> clean);
    bool followInHand(ByteReader& in);
    std::optional<int> indexOf(StepNumber number) const;

    EditedDocument document_;
    History history_;
    StepNumber firstStep_; ///< of history_ before it forgets any
    JournalOrigin origin_;
    std::optional<ObjectInHand> inHand_;
};

/// Reads a leftover: replays a journal, with its history, or reads an SVG file, without one. On
/// any thread. An error is a sentence.
Result<Recovered> recover(const Leftover& leftover);

} // namespace app

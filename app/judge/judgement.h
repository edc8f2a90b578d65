// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/judge/question.h"

#include <QString>

#include <span>

namespace app::plug_in {

/// What can be wrong with an answer, or happen instead of one.
enum class Fault : std::uint8_t {
    Crashed,
    DidNotEnd,
    LeftProgram,
    WroteBeyond,
    Nonsense,
    NotANumber,
    Changed,
    Lost,
    Invented,
    Outside,
    Turned,
    Off,
};

/// One row of the catalogue of faults, in the order of the enum: the worst first.
struct FaultInfo {
    Fault fault;
    QString key;      ///< in files: "lost"
    QString name;     ///< "Lost", translated
    QString sentence; ///< what it does, after its name: "loses lines that are visible"
    bool fatal;       ///< whether the child is gone
};
std::span<const FaultInfo> faults();
const FaultInfo& infoOf(Fault fault);

/// What a library is held to. With M the largest |coordinate| of line and window: ends may be off
/// by `ulps` of M, and a wrong visibility is possible only where moving the edges by so much
/// changes it. Textbook: ends may lie outside the window by as much, since textbooks do not speak
/// of rounding. Clearcuts: never by one bit, and an end that was inside comes back as it was; then
/// numbers near the ends of the double's range are asked about, too.
enum class Strictness : std::uint8_t { Textbook, Clearcuts };
struct Contract {
    double ulps = 64;
    Strictness strictness = Strictness::Textbook;
};

/// "strict", "textbook": in files and between processes, and back.
QString wordOf(Strictness strictness);
Strictness strictnessOf(const QString& word);

/// How an answer compares with the truth.
struct Judgement {
    std::optional<Fault> fault{};
    double off = 0;     ///< the ends, in ulps of M; 0 where only one of the two is visible
    double outside = 0; ///< how far outside the window an end lies, in ulps of M
};

/// The truth is what the row `exact` says. `visibilityUlps`: how far edges may move, which is less
/// than the contract's where every right formula is exact.
Judgement judged(const Question& question, const Answer& answer, const Contract& contract,
                 double visibilityUlps);

/// What is truly visible.
std::optional<clipping::Segment> expected(const Question& question);

} // namespace app::plug_in

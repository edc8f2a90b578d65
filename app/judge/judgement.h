// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/geometry.h"

#include <QString>

#include <array>
#include <cstdint>
#include <optional>
#include <span>

// The bytes sent through the pipes between the judge and its child, which are the same program.

namespace app::plug_in {

/// One line to clip at one window.
struct Question {
    clipping::Segment line;
    clipping::Window window;
};
static_assert(sizeof(Question) == 64);

/// The output of the library's function.
struct Answer {
    std::array<double, 4> visible; ///< NaN where nothing was written
    std::int32_t returned;
    std::uint32_t wroteBeyond; ///< 1: the function wrote outside visible[0] to [3]

    std::optional<clipping::Segment> piece() const
    {
        if (returned == 0)
            return std::nullopt;
        return clipping::Segment{{visible[0], visible[1]}, {visible[2], visible[3]}};
    }
};
static_assert(sizeof(Answer) == 40);

} // namespace app::plug_in

namespace app::plug_in {

/// The faults of an answer, or events that prevent one.
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
    QString sentence; ///< follows the library's name: "loses lines that are visible"
    bool fatal;       ///< whether the child process has ended
};
std::span<const FaultInfo> faults();
const FaultInfo& infoOf(Fault fault);

/// The contract of a library. With M the largest |coordinate| of line and window: ends may be off
/// by `ulps` of M, and a visibility may be wrong only if moving the edges by that much changes it.
/// Textbook: ends may lie outside the window by that much, since textbooks ignore rounding.
/// Clearcuts: never outside by even one bit, and an end that was inside is unchanged; this contract
/// also tests numbers near the ends of the range of double.
enum class Strictness : std::uint8_t { Textbook, Clearcuts };
struct Contract {
    double ulps = 64;
    Strictness strictness = Strictness::Textbook;
};

/// "strict", "textbook": for files and between processes. strictnessOf is the inverse.
QString wordOf(Strictness strictness);
Strictness strictnessOf(const QString& word);

/// The comparison of an answer with the exact result.
struct Judgement {
    std::optional<Fault> fault{};
    double off = 0;     ///< error of the ends in ulps of M; 0 if only one of the two is visible
    double outside = 0; ///< distance of an end outside the window, in ulps of M
};

/// The reference is the algorithm `exact`. `visibilityUlps`: how far edges may move, which is less
/// than the contract allows where every correct formula is exact.
Judgement judged(const Question& question, const Answer& answer, const Contract& contract,
                 double visibilityUlps);

/// The exact visible part.
std::optional<clipping::Segment> expected(const Question& question);

} // namespace app::plug_in

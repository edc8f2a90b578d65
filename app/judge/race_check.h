// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/clock.h"
#include "app/judge/judgement.h"

#include <QByteArray>

#include <vector>

namespace app::plug_in {

/// A line that was wrong in the race.
struct RaceFinding {
    Fault fault;
    Question question;
    Answer answer; ///< of a changed one: the later one
};

/// What a library got wrong in the race, a line once.
struct RaceFindings {
    std::size_t lines = 0; ///< that it clipped, those of each class of line again
    std::vector<std::size_t> byFault = std::vector<std::size_t>(faults().size());
    std::size_t visible = 0, wrongVisible = 0; ///< truly visible lines, and those of them wrong
    std::size_t outside = 0; ///< ends that rounding left outside the window, within the contract
    double mostOff = 0;      ///< ulps, among what was right
    std::vector<RaceFinding> first{}; ///< some of what was wrong

    std::size_t wrong() const;
};

/// In one line, and back; nothing if it is not what was written.
QByteArray jsonOf(const RaceFindings& found);
std::optional<RaceFindings> raceFindingsOf(const QByteArray& json);

/// Compares what a library finds in each of its turns of a race: the first time that some lines
/// come with the truth, later with what it found then.
class RaceCheck {
public:
    explicit RaceCheck(const Contract& contract) : contract_(contract) {}

    /// After each turn; the pieces in the order of the lines.
    void turn(std::span<const clipping::Segment> lines, const clipping::Window& window,
              std::span<const clipping::Clipped> pieces);
    const RaceFindings& found() const { return found_; }
    /// What the turns are timed with: it stands still while they are checked.
    Clock clock() const;

private:
    void judgeAll(std::span<const clipping::Clipped> pieces);
    void compare(std::span<const clipping::Clipped> pieces);
    void add(Fault fault, std::size_t line, const std::optional<clipping::Segment>& piece);
    bool isKnown(std::span<const clipping::Segment> lines) const;

    Contract contract_;
    RaceFindings found_;
    std::vector<clipping::Segment> lines_; ///< of the turns until others come
    clipping::Window window_{};
    std::vector<clipping::Clipped> pieces_; ///< of the first turn on these lines
    std::uint64_t sum_ = 0;                 ///< of these pieces
    std::vector<bool> wrong_;               ///< of these lines: told already
    Clock clock_ = processorClock();
    double paused_ = 0;
};

} // namespace app::plug_in

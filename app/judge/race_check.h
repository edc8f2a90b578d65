// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/clock.h"
#include "app/judge/judgement.h"

#include <QByteArray>

#include <vector>

namespace app::plug_in {

/// A wrong line of the race.
struct RaceFinding {
    Fault fault;
    Question question;
    Answer answer; ///< for a changed answer: the later one
};

/// The errors of a library in the race; each line counts once.
struct RaceFindings {
    std::size_t lines = 0; ///< lines that it clipped; lines of each class count again
    std::vector<std::size_t> byFault = std::vector<std::size_t>(faults().size());
    std::size_t visible = 0, wrongVisible = 0; ///< visible lines, and the wrong ones of these
    std::size_t outside = 0; ///< ends that rounding left outside the window, within the contract
    double mostOff = 0;      ///< in ulps, of the right answers
    std::vector<RaceFinding> first{}; ///< some of the wrong lines

    std::size_t wrong() const;
};

/// Converts to JSON on one line, and back; empty if the text is not such JSON.
QByteArray jsonOf(const RaceFindings& found);
std::optional<RaceFindings> raceFindingsOf(const QByteArray& json);

/// Checks the library's results in each of its turns in a race: the first time, lines are compared
/// with the exact result, later with the library's own first result.
class RaceCheck {
public:
    explicit RaceCheck(const Contract& contract) : contract_(contract) {}

    /// Call this after each turn; the pieces are in the order of the lines.
    void turn(std::span<const clipping::Segment> lines, const clipping::Window& window,
              std::span<const clipping::Clipped> pieces);
    const RaceFindings& found() const { return found_; }
    /// The clock that times the turns; it stands still during checks.
    Clock clock() const;

private:
    void judgeAll(std::span<const clipping::Clipped> pieces);
    void compare(std::span<const clipping::Clipped> pieces);
    void add(Fault fault, std::size_t line, const std::optional<clipping::Segment>& piece);
    bool isKnown(std::span<const clipping::Segment> lines) const;

    Contract contract_;
    RaceFindings found_;
    std::vector<clipping::Segment> lines_; ///< of the turns until other lines come
    clipping::Window window_{};
    std::vector<clipping::Clipped> pieces_; ///< of the first turn on these lines
    std::uint64_t sum_ = 0;                 ///< of these pieces
    std::vector<bool> wrong_;               ///< for each of these lines: reported already
    Clock clock_ = processorClock();
    double paused_ = 0;
};

} // namespace app::plug_in

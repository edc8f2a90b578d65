// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/comparison/difference.h"
#include "app/experiment/experiment.h"
#include "app/scene/scene_lines.h"

namespace app {

/// The lines and the window of a race.
struct RaceFrame {
    SceneLines lines;
    clipping::Window window{};

    bool sameAs(const RaceFrame& other) const { return is(other.lines, other.window); }
    /// It is of the very same lines, at this window.
    bool is(const SceneLines& ofThese, const clipping::Window& atThis) const
    {
        return lines.revision() == ofThese.revision() && window == atThis;
    }
};

/// The times and the results of one variant.
struct RaceRow {
    Variant variant;
    std::vector<double> milliseconds{}; ///< for all lines, of the last rounds, the newest last
    std::size_t ofThisFrame = 0;        ///< how many of them: those at the end
    std::size_t visible = 0;            ///< lines
    DifferenceCounts differences{};     ///< A is the variant, B `exact`
    double operations = 0; ///< a line: comparisons, additions, multiplications, divisions

    /// Of the rounds of this frame, or of all of them as long as those are too few to say anything:
    /// the times, as many for every row of a race, and their summary.
    std::span<const double> times() const;
    Summary summary() const { return summaryOf(times()); }
};

/// All variants clip the same frame, round by round, each in turn and each into the same buffer;
/// who begins changes from round to round. A round is made of many short steps, so that between
/// them a window can answer. What is truly visible is what the row `exact` says. One thread.
class Race {
public:
    static constexpr std::size_t length = 40; ///< rounds that are remembered
    /// Lines whose arithmetic is counted, evenly spread: in the first round for findings
    /// of a frame, and in the second one, if there is one. Fewer lines are all counted.
    static constexpr std::size_t quickSample = 256, thoroughSample = 16384;

    /// Of at least one.
    explicit Race(const std::vector<Variant>& variants, Clock clock = processorClock());

    /// What a round is for: only times, or also what has not been found out of this frame yet,
    /// which takes a sixth more; until then rows keep what was found before.
    enum class Purpose : std::uint8_t { Times, Findings };
    /// Begins a round. Times of another number of lines are forgotten. No round is under way.
    void begin(const RaceFrame& frame, Purpose purpose = Purpose::Findings);
    bool running() const { return racing_; }
    /// One variant's turn on some of the lines, which takes some milliseconds. True: it was the
    /// round's last one.
    bool step();
    /// Gives up the round under way, of which nothing is kept.
    void drop() { racing_ = false; }

    /// After the last round that was finished, in the order of the variants.
    const std::vector<RaceRow>& rows() const { return rows_; }
    const RaceFrame& frame() const { return frame_; } ///< of the last round that was begun
    std::size_t rounds() const { return rounds_; }    ///< finished ones, of this frame

private:
    std::size_t blocks() const { return blocks_.size(); }
    bool judges() const { return purpose_ == Purpose::Findings && looks_ == 0; }
    bool counts() const;
    std::size_t turns() const;
    void clip(std::size_t variant, std::size_t block);
    void judge(RaceRow& row, std::size_t block, std::span<const clipping::Clipped> found);
    void count(std::size_t variant);
    void finish();

    Clock clock_;
    std::vector<RaceRow> rows_, next_; ///< next_: what the round under way finds
    std::vector<double> nanoseconds_;  ///< of the round under way
    RaceFrame frame_;
    std::vector<std::span<const clipping::Segment>> blocks_; ///< of its lines, one at least
    std::size_t rounds_ = 0;
    std::size_t looks_ = 0; ///< rounds for findings among them
    std::size_t begun_ = 0; ///< rounds of all frames: whose turn it is to begin
    std::size_t turn_ = 0;  ///< of the round under way
    Purpose purpose_ = Purpose::Findings;
    bool racing_ = false;
    std::vector<clipping::Segment> sample_;
    std::vector<clipping::Clipped> found_; ///< in all lines; sources count in their block
    std::vector<clipping::Clipped> truth_; ///< in the block that is judged
};

} // namespace app

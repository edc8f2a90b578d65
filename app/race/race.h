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
    /// Whether the frame has exactly these lines and this window.
    bool is(const SceneLines& ofThese, const clipping::Window& atThis) const
    {
        return lines.revision() == ofThese.revision() && window == atThis;
    }
};

/// The times and the results of one variant.
struct RaceRow {
    Variant variant;
    std::vector<double> milliseconds{}; ///< for all lines, of the last rounds, the newest last
    std::size_t ofThisFrame = 0;        ///< how many of them, at the end, are of this frame
    std::size_t visible = 0;            ///< number of visible lines
    DifferenceCounts differences{};     ///< A is the variant, B `exact`
    double operations = 0; ///< per line: comparisons, additions, multiplications, divisions

    /// The times of this frame's rounds, or of all rounds while those are too few, and their
    /// summary, which is 0 without any. Every row of a race has the same number of times.
    std::span<const double> times() const;
    Summary summary() const { return milliseconds.empty() ? Summary{} : summaryOf(times()); }
};

/// All variants clip the same frame, round by round, one after the other and into the same buffer;
/// the first variant changes from round to round. A round consists of many short steps, so that a
/// window can respond between them. The reference for visibility is the algorithm `exact`. One
/// thread.
class Race {
public:
    static constexpr std::size_t length = 40; ///< number of rounds that are remembered
    /// The number of lines whose operations are counted, evenly spread: in a frame's first round
    /// for findings, and in its second one. If there are fewer lines, all are counted.
    static constexpr std::size_t quickSample = 256, thoroughSample = 16384;

    /// `variants` has at least one element.
    explicit Race(const std::vector<Variant>& variants, Clock clock = processorClock());

    /// The purpose of a round: only times, or also the findings that this frame lacks, which takes
    /// a sixth longer. Until then rows keep the earlier findings.
    enum class Purpose : std::uint8_t { Times, Findings };
    /// Begins a round. Discards the earlier times if the number of lines has changed. No round may
    /// be running.
    void begin(const RaceFrame& frame, Purpose purpose = Purpose::Findings);
    bool running() const { return racing_; }
    /// One variant's turn on some of the lines, which takes some milliseconds. Returns true after
    /// the last step of a round.
    bool step();
    /// Stops the running round and discards its results.
    void drop() { racing_ = false; }

    /// The state after the last finished round, in the order of the variants.
    const std::vector<RaceRow>& rows() const { return rows_; }
    const RaceFrame& frame() const { return frame_; } ///< of the last round that was started
    std::size_t rounds() const { return rounds_; }    ///< finished rounds of this frame

private:
    std::size_t blocks() const { return blocks_.size(); }
    bool judges() const { return purpose_ == Purpose::Findings && looks_ == 0; }
    bool counts() const;
    std::size_t turns() const;
    void clip(std::size_t variant, std::size_t block);
    void judge(RaceRow& row, std::size_t block, std::span<const clipping::Clipped> found);
    void count(std::size_t variant, std::size_t part);
    void finish();

    Clock clock_;
    std::vector<RaceRow> rows_, next_; ///< next_: results of the running round
    std::vector<double> nanoseconds_;  ///< of the running round
    RaceFrame frame_;
    std::vector<std::span<const clipping::Segment>> blocks_; ///< of the frame's lines; at least one
    std::size_t rounds_ = 0;
    std::size_t looks_ = 0; ///< number of the frame's rounds for findings
    std::size_t begun_ = 0; ///< rounds of all frames; determines the first variant
    std::size_t turn_ = 0;  ///< of the running round
    Purpose purpose_ = Purpose::Findings;
    bool racing_ = false;
    std::vector<clipping::Segment> sample_;
    std::vector<clipping::Clipped> found_; ///< in all lines; sources are relative to their block
    std::vector<clipping::Clipped> exactPieces_; ///< in the current block
};

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/race/race.h"
#include "app/scene/scene.h"

#include <QElapsedTimer>
#include <QTimer>

namespace app {

/// A race on the visible drawing while a panel shows it: whenever the clip window or the lines
/// change (at most one round per frame), and then ten rounds a second until the times have settled.
/// Findings are examined at most ten times a second. It works between events, some milliseconds at
/// a time and never before a pending frame, so that nothing waits for it; the window may move
/// meanwhile, and the next round uses the newest one.
class LiveRace : public QObject {
    Q_OBJECT

public:
    LiveRace(const EditedDocument& document, const Scene& scene, QObject* parent = nullptr);

    /// The current place of the clip window, also during a drag; empty: there is none, and the race
    /// has no rows.
    void setWindow(const std::optional<clipping::Window>& window);
    /// Sets the competing variants, at least one; forgets all measurements.
    void setVariants(std::vector<Variant> variants);
    std::span<const Variant> variants() const { return variants_; }
    void start(); ///< on what is shown now
    void stop();  ///< forgets all measurements
    bool running() const { return race_.has_value(); }

    /// The rows after the last finished round; empty before the first one.
    std::span<const RaceRow> rows() const;
    std::size_t lines() const; ///< of that round
    /// Whether the last finished round is on what is shown.
    bool upToDate() const;
    /// Enough was measured of what is shown: no further rounds run.
    bool settled() const { return settled_; }

signals:
    void advanced(); ///< rounds have finished, or the race has settled; at most ten times a second

private:
    void follow(const DocumentChange& change);
    bool isOnWhatIsShown() const; ///< the running round, or the last one
    void begin();
    void work();
    void finishRound();
    bool enough() const;

    const Scene& scene_;
    std::optional<clipping::Window> window_;
    std::vector<Variant> variants_;
    std::optional<Race> race_;
    bool settled_ = false;
    QElapsedTimer sinceNew_, sinceBegin_, sinceFindings_;
    QTimer work_, next_, show_;
};

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/race/race.h"
#include "app/session/session.h"

#include <QElapsedTimer>
#include <QTimer>

namespace app {

/// A race on what an editor shows, while a panel shows it: whenever the clip window lies elsewhere
/// or the lines change (at most one round a frame), and then ten rounds a second until the numbers
/// have settled. What they find is looked at ten times a second at most. It works between events,
/// some milliseconds at a time and never before the frame that is due, so that nothing has to wait
/// for it; the window moves on meanwhile, and the next round is on the newest one.
class LiveRace : public QObject {
    Q_OBJECT

public:
    explicit LiveRace(const Session& session, QObject* parent = nullptr);

    /// Who races, at least one; what was measured is forgotten.
    void setVariants(std::vector<Variant> variants);
    std::span<const Variant> variants() const { return variants_; }
    void start(); ///< on what is shown now
    void stop();  ///< what was measured is forgotten
    bool running() const { return race_.has_value(); }

    /// After the last finished round; none before the first one.
    std::span<const RaceRow> rows() const;
    std::size_t lines() const; ///< of that round
    /// The last finished round is on what is shown.
    bool upToDate() const;
    /// Enough has been measured of what is shown: nothing goes on.
    bool settled() const { return settled_; }

signals:
    void advanced(); ///< rounds were finished, or it has settled; at most ten times a second

private:
    void followWindow();
    void follow(const DocumentChange& change);
    bool isOnWhatIsShown() const; ///< the round under way, or the last one
    void begin();
    void work();
    void roundOver();
    bool enough() const;

    const Session& session_;
    std::vector<Variant> variants_;
    std::optional<Race> race_;
    bool settled_ = false;
    QElapsedTimer sinceNew_, sinceBegin_, sinceFindings_;
    QTimer work_, next_, show_;
};

} // namespace app

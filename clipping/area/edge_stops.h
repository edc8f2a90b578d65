// SPDX-License-Identifier: MIT
#pragma once

#include "clipping/region/edges_near.h"
#include "clipping/region/meeting.h"

namespace clipping {

/// The places between the ends of an edge where other edges meet it, in their exact order. Keeps
/// its memory from one edge to the next.
class EdgeStops {
public:
    struct Stop {
        Meeting meeting;
        bool isOfWindow; ///< whether the meeting's edge is
        int covers;      ///< 0, or for an edge along this one that comes before it: 1 where it
                         ///< begins, -1 where it ends; the meeting is but its place
    };
    /// The edge itself, and the edges of a region that come before it, should they lie along it.
    struct Rank {
        const AreaEdge* edge;
        const AreaEdge* allBefore; ///< edges at smaller addresses come before it
    };

    void clear() { stops_.clear(), along_.clear(), keys_.clear(); }
    /// Adds the stops at edges of a region. Returns whether none of them, except the one that
    /// follows it in memory, touches the end of the edge.
    bool find(const SweptLine& swept, const Rank& rank, EdgesNear& near, bool isOfWindow);
    bool isEmpty() const { return stops_.empty(); }
    /// Orders all stops.
    void sort(const SweptLine& swept);

    std::size_t size() const { return keys_.size(); }
    const Stop& operator[](std::size_t i) const { return stops_[keys_[i].stop]; }
    /// Whether two stops, of which the first one does not come later, are in the same place.
    bool areTogether(const SweptLine& swept, std::size_t first, std::size_t second) const
    {
        return keys_[first].high >= keys_[second].low
               && !(order(swept, (*this)[first].meeting, (*this)[second].meeting) < 0);
    }
    /// How many edges that come before this one lie along it just after its start.
    int coversFrom(const SweptLine& swept) const;

private:
    /// A stop and the bounds of its share of the way, infinite if unknown.
    struct Key {
        double low, high;
        std::uint32_t stop;
    };

    bool comesBefore(const SweptLine& swept, const Key& p, const Key& q) const;
    void addKeys();
    void addCovers(const SweptLine& swept);

    std::vector<Stop> stops_;
    std::vector<Key> keys_;
    std::vector<const AreaEdge*> along_; ///< edges along this one that come before it
};

} // namespace clipping

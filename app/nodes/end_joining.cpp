// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/end_joining.h"

#include "app/nodes/nearest_points.h"
#include "app/nodes/node_types.h"
#include "app/nodes/subpath_edits.h"

#include <algorithm>
#include <cassert>
#include <functional>
#include <queue>
#include <tuple>

namespace app {
namespace {

/// End 2 i is the start of subpath i, end 2 i + 1 its last node.
using End = std::size_t;
constexpr End none = ~End(0);

End otherEnd(End end) { return end ^ 1; }

/// Which ends are joined.
class Joints {
public:
    Joints(const NodePath& path, std::span<const std::uint32_t> pens)
        : path_(path), pens_(pens), partner_(2 * path.size(), none)
    {
        for (std::size_t i = 0; i < path.size(); ++i)
            if (!path[i].closed && path[i].nodes.size() > 1)
                open_.insert(open_.end(), {2 * i, 2 * i + 1});
        std::vector<End> selected;
        std::ranges::copy_if(open_, std::back_inserter(selected),
                             [this](End end) { return node(end).selected; });
        chosen_ = selected.size() >= 2;
        if (chosen_)
            open_ = std::move(selected);
    }

    End partner(End end) const { return partner_[end]; }
    std::size_t count() const { return count_; }

    void joinNear(double tolerance)
    {
        std::vector<End> sorted = open_; // those on one spot are neighbours
        std::ranges::sort(sorted, {}, [this](End end) {
            return std::tuple(pen(end), node(end).at.x, node(end).at.y, end);
        });
        const auto samePen = [this](End a, End b) { return pen(a) == pen(b); };
        const auto sameSpot = [&](End a, End b) {
            return samePen(a, b) && node(a).at == node(b).at;
        };
        forEachGroup(sorted, sameSpot, [this](std::span<const End> ends) { joinOnOneSpot(ends); });
        std::erase_if(sorted, [this](End end) { return partner_[end] != none; });
        forEachGroup(sorted, samePen,
                     [&](std::span<const End> ends) { joinNearest(ends, tolerance); });
    }
    void joinByLine()
    {
        if (chosen_ && open_.size() == 2 && pen(open_[0]) == pen(open_[1]))
            join(open_[0], open_[1]);
    }

private:
    const Node& node(End end) const
    {
        const auto& nodes = path_[end / 2].nodes;
        return end % 2 ? nodes.back() : nodes.front();
    }
    std::uint32_t pen(End end) const { return pens_[end / 2]; }
    /// A short line is not joined to itself.
    bool isOneLine(End end) const
    {
        const auto& nodes = path_[end / 2].nodes;
        return nodes.size() == 2 && !nodes[0].curved;
    }
    bool mayJoin(End a, End b) const { return b != otherEnd(a) || !isOneLine(a); }
    void join(End a, End b)
    {
        partner_[a] = b;
        partner_[b] = a;
        ++count_;
    }

    template <class Same, class Visit>
    static void forEachGroup(std::span<const End> ends, const Same& same, const Visit& visit)
    {
        for (std::size_t first = 0, next = 0; first < ends.size(); first = next) {
            for (next = first + 1; next < ends.size() && same(ends[first], ends[next]);)
                ++next;
            visit(ends.subspan(first, next - first));
        }
    }

    /// Each with the next one that is free.
    void joinOnOneSpot(std::span<const End> ends)
    {
        for (std::size_t i = 0; i < ends.size(); ++i)
            for (std::size_t k = i + 1; k < ends.size() && partner_[ends[i]] == none; ++k)
                if (partner_[ends[k]] == none && mayJoin(ends[i], ends[k]))
                    join(ends[i], ends[k]);
    }

    /// Of all pairs the nearest first.
    void joinNearest(std::span<const End> ends, double tolerance)
    {
        struct Pair {
            double distance;
            std::size_t first, second; ///< numbers in `sorted`
            std::size_t of;            ///< the one whose nearest is the other
            auto operator<=>(const Pair&) const = default;
        };
        std::vector<End> sorted(ends.begin(), ends.end());
        std::ranges::sort(sorted);
        std::vector<Point> points;
        for (const End end : sorted)
            points.push_back(node(end).at);
        NearestPoints left(std::move(points));
        std::priority_queue<Pair, std::vector<Pair>, std::greater<>> pairs;
        // The other end of a short line, which does not count; otherwise the end itself.
        const auto besides = [&](std::size_t i) {
            const std::size_t other = sorted[i] % 2 ? i - 1 : i + 1;
            return other < sorted.size() && !mayJoin(sorted[i], sorted[other]) ? other : i;
        };
        const auto offer = [&](std::size_t i) {
            if (const auto near = left.nearest(i, tolerance, besides(i)))
                pairs.push({near->distance, std::min(i, near->point), std::max(i, near->point), i});
        };
        for (std::size_t i = 0; i < sorted.size(); ++i)
            offer(i);
        while (!pairs.empty()) {
            const Pair pair = pairs.top();
            pairs.pop();
            if (partner_[sorted[pair.of]] != none)
                continue;
            if (partner_[sorted[pair.first]] == none && partner_[sorted[pair.second]] == none) {
                join(sorted[pair.first], sorted[pair.second]);
                left.remove(pair.first);
                left.remove(pair.second);
            } else {
                offer(pair.of);
            }
        }
    }

    const NodePath& path_;
    std::span<const std::uint32_t> pens_;
    std::vector<End> partner_; ///< of each end; none: it stays an end
    std::vector<End> open_;    ///< the ends that count
    bool chosen_ = false;      ///< they are the selected ones
    std::size_t count_ = 0;
};

/// The last node of one subpath becomes the first one of another, too.
void mergeInto(Node& node, const Node& next)
{
    const Point middle = node.at == next.at ? node.at : node.at * 0.5 + next.at * 0.5;
    node.in = node.in == node.at ? middle : node.in + (middle - node.at);
    node.out = next.out == next.at ? middle : next.out + (middle - next.at);
    node.curved = next.curved;
    node.at = middle;
    node.selected = node.selected || next.selected;
}

/// Puts subpaths together. Joined ends become one node (`merges`), or a straight segment.
class Chains {
public:
    Chains(NodePath& path, const Joints& joints, bool merges)
        : path_(path), joints_(joints), merges_(merges), gone_(path.size())
    {
    }

    void join(std::vector<std::size_t>& owners)
    {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < path_.size(); ++i) {
            if (gone_[i])
                continue;
            if (joints_.partner(2 * i) != none || joints_.partner(2 * i + 1) != none)
                path_[i] = chainOf(i);
            if (kept != i)
                path_[kept] = std::move(path_[i]);
            owners[kept++] = owners[i];
        }
        path_.resize(kept);
        owners.resize(kept);
    }

private:
    /// Where the chain begins that contains the subpath, in its direction; a closed one at its
    /// start.
    End beginOf(std::size_t subpath) const
    {
        const End start = 2 * subpath;
        End begin = start;
        while (joints_.partner(begin) != none) {
            begin = otherEnd(joints_.partner(begin));
            if (begin == start)
                break;
        }
        return begin;
    }
    NodeSubpath takeFrom(End first)
    {
        NodeSubpath taken = std::move(path_[first / 2]);
        gone_[first / 2] = true;
        if (first % 2)
            reverse(taken);
        return taken;
    }
    NodeSubpath chainOf(std::size_t subpath)
    {
        const End begin = beginOf(subpath);
        NodeSubpath whole = takeFrom(begin);
        End next = joints_.partner(otherEnd(begin));
        for (; next != none && next != begin; next = joints_.partner(otherEnd(next)))
            append(whole.nodes, takeFrom(next).nodes);
        if (next == begin)
            closeChain(whole);
        for (std::size_t i = 0; i < whole.nodes.size(); ++i)
            whole.nodes[i].type = typeOf(whole, i);
        return whole;
    }
    void append(std::vector<Node>& nodes, const std::vector<Node>& more) const
    {
        if (merges_)
            mergeInto(nodes.back(), more.front());
        nodes.insert(nodes.end(), more.begin() + int(merges_), more.end());
    }
    void closeChain(NodeSubpath& whole) const
    {
        if (!merges_ || whole.nodes.size() < 3) {
            close(whole);
            return;
        }
        Node last = whole.nodes.back();
        mergeInto(last, whole.nodes.front());
        whole.nodes.front() = last;
        whole.nodes.pop_back();
        whole.closed = true;
    }

    NodePath& path_;
    const Joints& joints_;
    bool merges_;
    std::vector<bool> gone_; ///< they are a part of another one now
};

} // namespace

std::size_t joinEnds(NodePath& path, std::vector<std::size_t>& owners, double tolerance,
                     std::span<const std::uint32_t> pens)
{
    assert(owners.size() == path.size() && pens.size() == path.size());
    Joints joints(path, pens);
    joints.joinNear(tolerance);
    const bool merges = joints.count() > 0;
    if (!merges)
        joints.joinByLine();
    if (joints.count() > 0)
        Chains(path, joints, merges).join(owners);
    return joints.count();
}

} // namespace app

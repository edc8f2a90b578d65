// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/end_joining.h"

#include "app/nodes/node_types.h"
#include "app/nodes/subpath_edits.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace app {
namespace {

// Where thousands of ends lie on one spot, the pairs of the first ones are enough.
constexpr std::size_t mostPairs = 1'000'000;

/// End 2 i is the start of subpath i as it was at first, end 2 i + 1 its last node.
using End = std::size_t;
struct Pair {
    End a, b;
    double distance;
};

class Joining {
public:
    explicit Joining(NodePath& path) : path_(path), state_(path.size())
    {
        for (std::size_t i = 0; i < path.size(); ++i) {
            ends_.push_back({2 * i, 2 * i + 1});
            subpathOf_.insert(subpathOf_.end(), 2, i);
            if (!path[i].closed && path[i].nodes.size() > 1)
                open_.insert(open_.end(), {2 * i, 2 * i + 1});
        }
        std::vector<End> selected;
        std::ranges::copy_if(open_, std::back_inserter(selected),
                             [this](End end) { return node(end).selected; });
        chosen_ = selected.size() >= 2;
        if (chosen_)
            open_ = std::move(selected);
    }

    std::size_t joinNear(double tolerance)
    {
        std::size_t joints = 0;
        std::vector<bool> used(subpathOf_.size());
        for (const Pair& pair : pairsWithin(tolerance)) {
            if (used[pair.a] || used[pair.b])
                continue;
            used[pair.a] = used[pair.b] = true;
            join(pair.a, pair.b, true);
            ++joints;
        }
        return joints;
    }
    std::size_t joinByLine()
    {
        if (!chosen_ || open_.size() != 2)
            return 0;
        join(open_[0], open_[1], false);
        return 1;
    }
    void finish(std::vector<std::size_t>& owners)
    {
        std::size_t kept = 0;
        for (std::size_t i = 0; i < path_.size(); ++i) {
            if (state_[i] == State::Gone)
                continue;
            for (std::size_t k = 0; state_[i] == State::Joined && k < path_[i].nodes.size(); ++k)
                path_[i].nodes[k].type = typeOf(path_[i], k);
            if (kept != i)
                path_[kept] = std::move(path_[i]);
            owners[kept++] = owners[i];
        }
        path_.resize(kept);
        owners.resize(kept);
    }

private:
    enum class State : std::uint8_t { Unchanged, Joined, Gone };

    const Node& node(End end) const
    {
        const auto& nodes = path_[end / 2].nodes;
        return end % 2 ? nodes.back() : nodes.front();
    }
    /// A short line is not joined to itself.
    bool isOneLine(End a, End b) const
    {
        const NodeSubpath& subpath = path_[a / 2];
        return a / 2 == b / 2 && subpath.nodes.size() == 2 && !subpath.nodes[0].curved;
    }
    std::vector<Pair> pairsWithin(double tolerance) const
    {
        std::vector<End> byX = open_;
        std::ranges::sort(byX, {}, [this](End end) { return node(end).at.x; });
        std::vector<Pair> pairs;
        for (std::size_t i = 0; i < byX.size(); ++i)
            for (std::size_t k = i + 1; k < byX.size() && pairs.size() < mostPairs; ++k) {
                const Point apart = node(byX[k]).at - node(byX[i]).at;
                if (apart.x > tolerance)
                    break;
                const double distance = std::hypot(apart.x, apart.y);
                if (distance <= tolerance && !isOneLine(byX[i], byX[k]))
                    pairs.push_back({std::min(byX[i], byX[k]), std::max(byX[i], byX[k]), distance});
            }
        std::ranges::sort(pairs, [](const Pair& p, const Pair& q) {
            return std::tie(p.distance, p.a, p.b) < std::tie(q.distance, q.a, q.b);
        });
        return pairs;
    }

    void join(End a, End b, bool merge)
    {
        const std::size_t first = std::min(subpathOf_[a], subpathOf_[b]);
        const std::size_t second = std::max(subpathOf_[a], subpathOf_[b]);
        if (first == second)
            return closeBy(first, merge);
        if (subpathOf_[a] != first)
            std::swap(a, b);
        NodeSubpath& whole = path_[first];
        NodeSubpath& more = path_[second];
        auto& [start, last] = ends_[first];
        auto& [moreStart, moreLast] = ends_[second];
        const bool before = a == start; // the second one is put before the first one
        if ((before ? moreLast : moreStart) != b) {
            reverse(more);
            std::swap(moreStart, moreLast);
        }
        const End newStart = before ? moreStart : start, newLast = before ? last : moreLast;
        if (before)
            std::swap(whole.nodes, more.nodes);
        append(whole.nodes, more.nodes, merge);
        more.nodes.clear();
        state_[first] = State::Joined;
        state_[second] = State::Gone;
        start = newStart;
        last = newLast;
        subpathOf_[start] = subpathOf_[last] = first;
    }
    static void append(std::vector<Node>& nodes, const std::vector<Node>& more, bool merge)
    {
        std::size_t from = 0;
        if (merge)
            mergeInto(nodes.back(), more[from++]);
        nodes.insert(nodes.end(), more.begin() + std::ptrdiff_t(from), more.end());
    }
    /// The last node of one subpath becomes the first one of another, too.
    static void mergeInto(Node& node, const Node& next)
    {
        const Point middle = node.at == next.at ? node.at : node.at * 0.5 + next.at * 0.5;
        node.in = node.in == node.at ? middle : node.in + (middle - node.at);
        node.out = next.out == next.at ? middle : next.out + (middle - next.at);
        node.curved = next.curved;
        node.at = middle;
        node.selected = node.selected || next.selected;
    }
    void closeBy(std::size_t subpath, bool merge)
    {
        NodeSubpath& closed = path_[subpath];
        state_[subpath] = State::Joined;
        if (!merge || closed.nodes.size() < 3) {
            close(closed);
            return;
        }
        Node last = closed.nodes.back();
        mergeInto(last, closed.nodes.front());
        closed.nodes.front() = last;
        closed.nodes.pop_back();
        closed.closed = true;
    }

    NodePath& path_;
    std::vector<State> state_;             ///< of each subpath
    std::vector<std::array<End, 2>> ends_; ///< of each subpath, as it is now
    std::vector<std::size_t> subpathOf_;   ///< of each end
    std::vector<End> open_;                ///< the ends that count
    bool chosen_ = false;                  ///< they are the selected ones
};

} // namespace

std::size_t joinEnds(NodePath& path, std::vector<std::size_t>& owners, double tolerance)
{
    Joining joining(path);
    std::size_t joints = joining.joinNear(tolerance);
    if (joints == 0)
        joints = joining.joinByLine();
    joining.finish(owners);
    return joints;
}

} // namespace app

// SPDX-License-Identifier: MIT
#include "clipping/ieee_numbers.h"
#include "clipping/region/edge_tree.h"

#include <limits>

namespace clipping {
namespace {

constexpr double mostCopies = 8; ///< of an edge, on average
/// Parts of edges that share an anchor; and areas for each of which it may have a winding number
/// without taking more memory than these parts.
constexpr std::size_t anchored = 64, fewSteps = 16;
constexpr double none = std::numeric_limits<double>::quiet_NaN();

/// A random sequence, always the same.
class Draw {
public:
    std::size_t below(std::size_t count)
    {
        state_ = state_ * 6364136223846793005u + 1442695040888963407u;
        return static_cast<std::size_t>((state_ >> 32) * count >> 32);
    }

private:
    std::uint64_t state_ = 1;
};

} // namespace

/// Divides cells into smaller ones. The parts of edges in all cells that are still to be divided
/// are in one row, those of the next one at its end.
class EdgeTree::Builder {
public:
    Builder(EdgeTree& tree, std::span<const AreaEdge> edges, std::size_t steps,
            std::size_t smallLeaf)
        : tree_(tree), edges_(edges), smallLeaf_(smallLeaf),
          anchored_(anchored * (1 + steps / fewSteps))
    {
        parts_.reserve(2 * edges.size());
        for (std::uint32_t i = 0; i < edges.size(); ++i)
            parts_.push_back({i, 0, 1});
        tree_.root_ = divide({});
    }

private:
    /// The part of an edge in a cell. Rounded outwards.
    struct EdgePart {
        std::uint32_t edge;
        float from, to;
    };
    /// Two points of a line that divided a cell's surroundings. Along a convex area, the edges in
    /// the cell begin and end there.
    struct Corners {
        glm::dvec2 a{none, none}, b{none, none};
    };
    struct Cell {
        std::size_t begin = 0; ///< its parts are from there to the end
        Corners corners{};
        std::uint32_t depth = 0;
        double copies = 1; ///< of each edge, if all nodes grow as those above
        bool hasAnchor = false;
    };
    struct Sides {
        std::size_t positive = 0, negative = 0; ///< parts on them; both of those that cross
        std::size_t larger() const { return std::max(positive, negative); }
    };

    /// By the line through two points. Where a cell is divided from one of its corners, the other
    /// corner is on one side.
    struct Division {
        Division() = default;
        explicit Division(const Segment& through) : Division(through, through.a) {}
        Division(const Segment& through, const glm::dvec2& other)
            : line{through.a, {}}, corners{through.a, through.b}, otherCorner(other)
        {
            const glm::dvec2 along = through.b - through.a;
            line.normal =
                glm::dvec2(-along.y, along.x) / std::max(std::abs(along.x), std::abs(along.y));
        }
        Corners cornersOf(double side) const
        {
            const glm::dvec2 value = (otherCorner - line.at) * line.normal;
            return side * (value.x + value.y) > 0 ? Corners{corners.b, otherCorner} : corners;
        }

        Line line{};
        Corners corners{};
        glm::dvec2 otherCorner{};
    };

    static EdgePart rounded(std::uint32_t edge, const Part& part)
    {
        constexpr float less = 1 - 0x1p-22f, more = 1 + 0x1p-22f;
        const auto from = static_cast<float>(part.from), to = static_cast<float>(part.to);
        return {edge, from > part.from ? from * less : from, to < part.to ? to * more : to};
    }
    std::array<Part, 2> sidesOf(const Line& line, const EdgePart& part) const
    {
        return line.sidesOf(edges_[part.edge].segment, {part.from, part.to}, tree_.margin_);
    }

    /// The child for the parts of a cell, which it removes.
    std::uint32_t divide(Cell cell)
    {
        const std::size_t begin = cell.begin, count = parts_.size() - begin;
        Division found;
        const bool isDivided = count > smallLeaf_ && cell.depth < mostDepth
                               && cell.copies < mostCopies && findLine(cell, found);
        if (!cell.hasAnchor && (count <= anchored_ || !isDivided)) {
            tree_.anchors_.push_back(anchorIn(begin));
            cell.hasAnchor = true;
        }
        if (!isDivided)
            return leaf(begin);
        // The negative ones go to the end, the others stay in place.
        std::size_t positive = begin;
        negative_.clear();
        for (std::size_t i = begin; i < parts_.size(); ++i) {
            const EdgePart part = parts_[i];
            const auto [above, below] = sidesOf(found.line, part);
            if (!above.isEmpty())
                parts_[positive++] = rounded(part.edge, above);
            if (!below.isEmpty())
                negative_.push_back(rounded(part.edge, below));
        }
        parts_.resize(positive);
        parts_.insert(parts_.end(), negative_.begin(), negative_.end());
        const auto all = static_cast<double>(parts_.size() - begin);
        cell.copies *= all / static_cast<double>(count);
        ++cell.depth;
        const auto node = static_cast<std::uint32_t>(tree_.nodes_.size());
        tree_.nodes_.push_back({found.line, {}});
        const std::uint32_t below =
            divide({positive, found.cornersOf(-1), cell.depth, cell.copies, cell.hasAnchor});
        cell.corners = found.cornersOf(1);
        const std::uint32_t above = divide(cell);
        tree_.nodes_[node].children = {above, below};
        return node;
    }

    std::uint32_t leaf(std::size_t begin)
    {
        const std::size_t number = tree_.firstEdge_.size() - 1;
        tree_.anchorOf_.push_back(static_cast<std::uint32_t>(tree_.anchors_.size() - 1));
        for (std::size_t i = begin; i < parts_.size(); ++i)
            tree_.edges_.push_back(parts_[i].edge);
        parts_.resize(begin);
        tree_.firstEdge_.push_back(static_cast<std::uint32_t>(tree_.edges_.size()));
        return static_cast<std::uint32_t>(number) | leafBit;
    }

    /// A point off the edges, if possible: on which side of an edge it is, is then soon decided.
    glm::dvec2 anchorIn(std::size_t begin) const
    {
        return middleOf(parts_[begin]) / 2.0 + middleOf(parts_.back()) / 2.0;
    }

    glm::dvec2 middleOf(const EdgePart& part) const
    {
        const auto& [a, b] = edges_[part.edge].segment;
        return a + (b - a) * ((double(part.from) + double(part.to)) / 2);
    }

    /// The best of some lines, as a sample of the parts says: of edges, from a corner of the cell,
    /// through the starts of two edges, or across one. Returns whether it divides them well.
    bool findLine(const Cell& cell, Division& best)
    {
        constexpr std::size_t samples = 16, lines = 3, tries = 16;
        const std::size_t count = parts_.size() - cell.begin;
        std::array<EdgePart, samples> sample;
        for (std::size_t trial = 0; trial < tries; ++trial) {
            for (EdgePart& part : sample)
                part = parts_[cell.begin + draw_.below(count)];
            constexpr std::size_t most = samples * 19 / 10;
            // In small cells, trying more costs more than it saves.
            const std::size_t good = count > anchored ? samples - 2 : most - 1;
            std::size_t fewest = most;
            const auto consider = [&](const Division& division) {
                const Sides sides = sidesOf(division.line, sample);
                const std::size_t cost = sides.positive + sides.negative - samples + sides.larger();
                if (cost < fewest && sides.larger() < samples)
                    fewest = cost, best = division;
            };
            for (std::size_t i = 0; i < lines; ++i)
                consider(Division(edges_[sample[i].edge].segment));
            const auto startOf = [&](std::size_t i) { return edges_[sample[i].edge].segment.a; };
            // Around a convex area, all others are on one side of an edge.
            const auto& [a, b] = cell.corners;
            for (std::size_t i = 0; i < lines && fewest > good; ++i) {
                consider(Division({a, startOf(i)}, b));
                consider(Division({b, startOf(i)}, a));
            }
            for (std::size_t i = 0; i < lines && fewest > good; ++i)
                consider(Division({startOf(2 * i), startOf(2 * i + 1)}));
            if (fewest > good) // all are on one line
                consider(Division({startOf(0), startOf(0) + acrossOf(sample[0])}));
            if (fewest < most)
                return true;
        }
        return false;
    }

    glm::dvec2 acrossOf(const EdgePart& part) const
    {
        const auto& [a, b] = edges_[part.edge].segment;
        return {a.y - b.y, b.x - a.x};
    }

    Sides sidesOf(const Line& line, std::span<const EdgePart> parts) const
    {
        Sides sides;
        for (const EdgePart& part : parts) {
            const auto [above, below] = sidesOf(line, part);
            sides.positive += !above.isEmpty();
            sides.negative += !below.isEmpty();
        }
        return sides;
    }

    EdgeTree& tree_;
    std::span<const AreaEdge> edges_;
    std::vector<EdgePart> parts_, negative_;
    std::size_t smallLeaf_, anchored_;
    Draw draw_;
};

void EdgeTree::divide(std::span<const AreaEdge> edges, std::size_t steps, std::size_t smallLeaf)
{
    Builder(*this, edges, steps, smallLeaf);
}

} // namespace clipping

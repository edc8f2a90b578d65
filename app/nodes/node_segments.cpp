// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/node_segments.h"

#include "app/nodes/node_types.h"

#include <glm/common.hpp>

#include <algorithm>

namespace app {
namespace {

int selectedEnds(const NodeSubpath& subpath, std::size_t segment)
{
    return int(subpath.nodes[segment].selected)
           + int(subpath.nodes[(segment + 1) % subpath.nodes.size()].selected);
}

template <class Change>
bool changeChosen(NodePath& path, bool curvedBefore, const Change& change)
{
    bool changed = false;
    for (const auto& [subpath, segment] : chosenSegments(path))
        if (path[subpath].nodes[segment].curved == curvedBefore) {
            change(path[subpath], segment);
            changed = true;
        }
    return changed;
}

} // namespace

std::vector<NodeAddress> chosenSegments(const NodePath& path)
{
    std::vector<NodeAddress> chosen;
    int most = 1;
    for (std::size_t s = 0; s < path.size(); ++s)
        for (std::size_t i = 0; i < path[s].segmentCount(); ++i) {
            const int ends = selectedEnds(path[s], i);
            if (ends > most)
                chosen.clear();
            most = std::max(most, ends);
            if (ends == most)
                chosen.push_back({s, i});
        }
    return chosen;
}

void straightenSegment(NodeSubpath& subpath, std::size_t segment)
{
    const std::size_t end = (segment + 1) % subpath.nodes.size();
    Node& from = subpath.nodes[segment];
    Node& to = subpath.nodes[end];
    from.curved = false;
    from.out = from.at;
    to.in = to.at;
    weakenType(subpath, segment);
    weakenType(subpath, end);
}

void curveSegment(NodeSubpath& subpath, std::size_t segment)
{
    const Bezier line = subpath.segment(segment);
    Node& from = subpath.nodes[segment];
    from.curved = true;
    from.out = line.control1;
    subpath.nodes[(segment + 1) % subpath.nodes.size()].in = line.control2;
}

bool makeStraight(NodePath& path) { return changeChosen(path, true, straightenSegment); }

bool makeCurved(NodePath& path) { return changeChosen(path, false, curveSegment); }

std::optional<std::size_t> insertNode(NodeSubpath& subpath, std::size_t segment, double t)
{
    if (!(t > 0 && t < 1) || segment >= subpath.segmentCount())
        return std::nullopt;
    const std::size_t end = (segment + 1) % subpath.nodes.size();
    Node& from = subpath.nodes[segment];
    Node& to = subpath.nodes[end];
    Node node;
    if (from.curved) {
        const Bezier whole = subpath.segment(segment);
        const Bezier first = whole.part(0, t), second = whole.part(t, 1);
        node = {first.to, first.control2, second.control1, NodeType::Smooth, true};
        from.out = first.control1;
        to.in = second.control2;
    } else {
        const Point at = glm::mix(from.at, to.at, t);
        node = {at, at, at};
    }
    subpath.nodes.insert(subpath.nodes.begin() + std::ptrdiff_t(segment + 1), node);
    weakenType(subpath, segment);
    weakenType(subpath, segment + 1);
    weakenType(subpath, (segment + 2) % subpath.nodes.size());
    return segment + 1;
}

bool insertInChosen(NodePath& path)
{
    const std::vector<NodeAddress> chosen = chosenSegments(path);
    for (std::size_t k = chosen.size(); k-- > 0;) { // the last first: numbers before it stay
        NodeSubpath& subpath = path[chosen[k].subpath];
        if (const auto added = insertNode(subpath, chosen[k].node, 0.5))
            subpath.nodes[*added].selected = true;
    }
    return !chosen.empty();
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/node_deletion.h"

#include "app/nodes/curve_fit.h"
#include "app/nodes/node_types.h"

#include <algorithm>

namespace app {
namespace {

void keepEnds(NodeSubpath& subpath)
{
    auto& nodes = subpath.nodes;
    const auto stays = [](const Node& node) { return !node.selected; };
    nodes.erase(nodes.begin(), std::ranges::find_if(nodes, stays));
    while (!nodes.empty() && nodes.back().selected)
        nodes.pop_back();
    if (nodes.empty())
        return;
    Node& first = nodes.front();
    Node& last = nodes.back();
    first.in = first.at;
    last.out = last.at;
    last.curved = false;
    first.type = last.type = NodeType::Corner;
}

/// One segment in place of those from node `from` to node `to` of the old subpath.
void bridge(const NodeSubpath& old, std::size_t from, std::size_t to, Node& first, Node& last)
{
    std::vector<Bezier> pieces;
    bool curved = false;
    for (std::size_t i = from; i < to; ++i) {
        pieces.push_back(old.segment(i));
        curved = curved || old.nodes[i].curved;
    }
    first.curved = curved;
    first.out = first.at;
    last.in = last.at;
    if (!curved)
        return;
    const Bezier curve = fitted(pieces);
    first.out = curve.control1;
    last.in = curve.control2;
}

/// The first node stays, and so does the last one of an open subpath.
void deleteBetween(NodeSubpath& subpath)
{
    const NodeSubpath old = subpath;
    const std::size_t count = old.nodes.size();
    std::vector<std::size_t> kept;
    for (std::size_t i = 0; i < count; ++i)
        if (!old.nodes[i].selected)
            kept.push_back(i);
    subpath.nodes.clear();
    for (const std::size_t i : kept)
        subpath.nodes.push_back(old.nodes[i]);
    for (std::size_t k = 0; k < kept.size(); ++k) {
        const bool last = k + 1 == kept.size();
        const std::size_t to = last ? count : kept[k + 1];
        if (to - kept[k] > 1)
            bridge(old, kept[k], to, subpath.nodes[k], subpath.nodes[last ? 0 : k + 1]);
    }
    for (std::size_t i = 0; i < subpath.nodes.size(); ++i)
        weakenType(subpath, i);
}

void deleteIn(NodeSubpath& subpath)
{
    auto& nodes = subpath.nodes;
    const auto kept = std::ranges::find_if(nodes, [](const Node& node) { return !node.selected; });
    if (kept == nodes.end())
        return nodes.clear();
    if (subpath.closed)
        std::rotate(nodes.begin(), kept, nodes.end());
    else
        keepEnds(subpath);
    deleteBetween(subpath);
    if (subpath.segmentCount() == 0)
        nodes.clear();
}

} // namespace

bool deleteSelected(NodePath& path)
{
    bool any = false;
    for (NodeSubpath& subpath : path)
        if (std::ranges::any_of(subpath.nodes, &Node::selected)) {
            deleteIn(subpath);
            any = true;
        }
    std::erase_if(path, [](const NodeSubpath& subpath) { return subpath.nodes.empty(); });
    return any;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/subpath_edits.h"

#include "app/nodes/node_types.h"

#include <algorithm>
#include <utility>

namespace app {
namespace {

Node asLast(Node node)
{
    node.out = node.at;
    node.curved = node.selected = false;
    node.type = NodeType::Corner;
    return node;
}

Node asFirst(Node node)
{
    node.in = node.at;
    node.type = NodeType::Corner;
    return node;
}

/// The parts of an open subpath between its selected nodes.
void appendParts(const NodeSubpath& open, NodePath& parts)
{
    NodeSubpath part;
    for (std::size_t i = 0; i < open.nodes.size(); ++i) {
        const Node& node = open.nodes[i];
        if (!node.selected || open.isEnd(i)) {
            part.nodes.push_back(node);
            continue;
        }
        part.nodes.push_back(asLast(node));
        parts.push_back(std::exchange(part, {}));
        part.nodes.push_back(asFirst(node));
    }
    parts.push_back(std::move(part));
}

} // namespace

void reverse(NodeSubpath& subpath)
{
    std::vector<bool> curvedInto;
    for (std::size_t i = 0; i < subpath.nodes.size(); ++i)
        curvedInto.push_back(subpath.curvedInto(i));
    for (std::size_t i = 0; i < subpath.nodes.size(); ++i) {
        Node& node = subpath.nodes[i];
        std::swap(node.in, node.out);
        node.curved = curvedInto[i];
    }
    std::reverse(subpath.nodes.begin() + (subpath.closed && !subpath.nodes.empty() ? 1 : 0),
                 subpath.nodes.end());
}

bool close(NodeSubpath& subpath)
{
    if (subpath.closed || subpath.nodes.size() < 2)
        return false;
    subpath.closed = true;
    Node& first = subpath.nodes.front();
    const Node& last = subpath.nodes.back();
    if (first.at == last.at) {
        first.in = last.in;
        first.selected = first.selected || last.selected;
        subpath.nodes.pop_back();
    }
    subpath.nodes.front().type = typeOf(subpath, 0);
    return true;
}

bool open(NodeSubpath& subpath, std::size_t at)
{
    if (!subpath.closed || at >= subpath.nodes.size())
        return false;
    auto& nodes = subpath.nodes;
    std::rotate(nodes.begin(), nodes.begin() + std::ptrdiff_t(at), nodes.end());
    const bool hasSegments = subpath.segmentCount() > 0;
    subpath.closed = false;
    if (hasSegments)
        nodes.push_back(asLast(nodes.front()));
    nodes.front() = asFirst(nodes.front());
    return true;
}

bool splitAtSelected(NodePath& path)
{
    NodePath parts;
    bool any = false;
    for (NodeSubpath& subpath : path) {
        const auto selected = std::ranges::find_if(subpath.nodes, &Node::selected);
        const std::size_t before = parts.size();
        if (subpath.closed && selected != subpath.nodes.end())
            any |= open(subpath, std::size_t(selected - subpath.nodes.begin()));
        if (subpath.closed)
            parts.push_back(std::move(subpath));
        else
            appendParts(subpath, parts);
        any |= parts.size() > before + 1;
    }
    path = std::move(parts);
    return any;
}

} // namespace app

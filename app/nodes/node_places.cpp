// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/node_places.h"

#include "app/base/finite.h"
#include "app/nodes/node_types.h"

#include <algorithm>

namespace app {
namespace {

/// Without rounding; a handle that lies on the node stays there.
void moveTo(Node& node, const Point& to)
{
    const Point by = to - node.at;
    for (Point* handle : {&node.in, &node.out})
        *handle = *handle == node.at ? to : *handle + by;
    node.at = to;
}

} // namespace

void alignAroundSelected(NodeSubpath& subpath)
{
    for (std::size_t i = 0; i < subpath.nodes.size(); ++i) {
        if (subpath.nodes[i].type == NodeType::Corner || subpath.isEnd(i))
            continue;
        const bool near = subpath.nodes[i].selected || subpath.nodes[*subpath.next(i)].selected
                          || subpath.nodes[*subpath.previous(i)].selected;
        if (near)
            alignToLine(subpath, i);
    }
}

bool placeSelected(NodePath& path, const std::function<Point(const Point& at)>& place)
{
    for (const NodeSubpath& subpath : path)
        for (const Node& node : subpath.nodes)
            if (node.selected && !isFinite(place(node.at)))
                return false;
    for (NodeSubpath& subpath : path) {
        for (Node& node : subpath.nodes)
            if (node.selected)
                moveTo(node, place(node.at));
        if (std::ranges::any_of(subpath.nodes, &Node::selected))
            alignAroundSelected(subpath);
    }
    return true;
}

} // namespace app

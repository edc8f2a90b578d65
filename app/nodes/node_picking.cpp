// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/node_picking.h"

#include <glm/common.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace app {
namespace {

constexpr int coarseSteps = 64;

double distance(const Point& a, const Point& b) { return std::hypot(a.x - b.x, a.y - b.y); }

bool boxIsNear(const Bezier& c, const Point& p, double radius)
{
    const Point least = glm::min(glm::min(c.from, c.to), glm::min(c.control1, c.control2));
    const Point most = glm::max(glm::max(c.from, c.to), glm::max(c.control1, c.control2));
    return p.x >= least.x - radius && p.x <= most.x + radius && p.y >= least.y - radius
           && p.y <= most.y + radius;
}

double nearestOnLine(const Bezier& c, const Point& p)
{
    const Point along = c.to - c.from;
    const double size = std::max(std::abs(along.x), std::abs(along.y));
    if (!(size > 0))
        return 0;
    const Point unit = along / size, to = (p - c.from) / size;
    return std::clamp((unit.x * to.x + unit.y * to.y) / (unit.x * unit.x + unit.y * unit.y), 0.0,
                      1.0);
}

class Handles {
public:
    explicit Handles(const NodePath& path) : path_(path) {}
    void add(std::size_t subpath, std::size_t node, HandleSide side, bool neighbours)
    {
        if (neighbours && path_[subpath].nodes[node].selected)
            return; // it is shown with its own node
        if (const auto at = handleOf(path_[subpath], node, side))
            shown.push_back({{subpath, node}, side, *at, neighbours});
    }
    std::vector<ShownHandle> shown;

private:
    const NodePath& path_;
};

} // namespace

std::optional<NodeAddress> nodeAt(const NodePath& path, const Point& point, double radius)
{
    std::optional<NodeAddress> found;
    double nearest = radius;
    bool selected = false;
    for (std::size_t s = 0; s < path.size(); ++s)
        for (std::size_t i = 0; i < path[s].nodes.size(); ++i) {
            const Node& node = path[s].nodes[i];
            if (!(std::abs(node.at.x - point.x) <= nearest))
                continue;
            const double apart = distance(node.at, point);
            if (apart < nearest || (apart == nearest && (node.selected || !selected))) {
                found = NodeAddress{s, i};
                nearest = apart;
                selected = node.selected;
            }
        }
    return found;
}

std::size_t nodesOn(const NodePath& path, const Point& spot)
{
    std::size_t count = 0;
    for (const NodeSubpath& subpath : path)
        count += std::size_t(std::ranges::count(subpath.nodes, spot, &Node::at));
    return count;
}

void selectWithin(NodePath& path, const clipping::Window& box)
{
    for (NodeSubpath& subpath : path)
        for (Node& node : subpath.nodes)
            if (node.at.x >= box.min.x && node.at.x <= box.max.x && node.at.y >= box.min.y
                && node.at.y <= box.max.y)
                node.selected = true;
}

std::vector<ShownHandle> shownHandles(const NodePath& path)
{
    Handles handles(path);
    std::size_t selected = 0;
    for (std::size_t s = 0; s < path.size(); ++s)
        for (std::size_t i = 0; i < path[s].nodes.size(); ++i) {
            if (!path[s].nodes[i].selected)
                continue;
            if (++selected > mostWithHandles)
                return {};
            handles.add(s, i, HandleSide::In, false);
            handles.add(s, i, HandleSide::Out, false);
            if (const auto before = path[s].previous(i))
                handles.add(s, *before, HandleSide::Out, true);
            if (const auto after = path[s].next(i))
                handles.add(s, *after, HandleSide::In, true);
        }
    return std::move(handles.shown);
}

std::optional<SegmentPoint> segmentAt(const NodePath& path, const Point& point, double radius)
{
    std::optional<SegmentPoint> found;
    double nearest = radius;
    for (std::size_t s = 0; s < path.size(); ++s)
        for (std::size_t i = 0; i < path[s].segmentCount(); ++i) {
            const Bezier c = path[s].segment(i);
            if (!boxIsNear(c, point, nearest))
                continue;
            const bool curved = path[s].nodes[i].curved;
            const double t =
                curved ? nearestParameter(c, point, coarseSteps) : nearestOnLine(c, point);
            const Point at = curved ? c.at(t) : glm::mix(c.from, c.to, t);
            const double apart = distance(at, point);
            if (apart <= nearest) {
                nearest = apart;
                found = SegmentPoint{{s, i}, t, at};
            }
        }
    return found;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/node_steps.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/nodes/end_joining.h"
#include "app/nodes/node_deletion.h"
#include "app/nodes/node_segments.h"
#include "app/nodes/node_types.h"
#include "app/nodes/subpath_edits.h"

#include <algorithm>
#include <array>

namespace app {
namespace {

QString always(const NodeSummary&) { return {}; }

QString endsHaveNoType(const NodeSummary& nodes)
{
    return nodes.selected > nodes.selectedEnds
               ? QString()
               : Text::tr("An end of an open path has only one handle. Select a node between two "
                          "segments.");
}

QString noSegment() { return Text::tr("There is no segment at the selected nodes."); }

template <NodeType type>
bool setType(OwnedPaths& paths, const JoinRule&)
{
    return setTypes(paths.path, type);
}

/// Deletion and splitting change the number of subpaths, so each object is changed on its own.
template <bool (*change)(NodePath&)>
bool ofEach(OwnedPaths& paths, const JoinRule&)
{
    OwnedPaths changed;
    bool any = false;
    for (std::size_t first = 0; first < paths.owners.size();) {
        const std::size_t owner = paths.owners[first];
        NodePath own;
        for (; first < paths.owners.size() && paths.owners[first] == owner; ++first)
            own.push_back(std::move(paths.path[first]));
        any |= change(own);
        changed.owners.insert(changed.owners.end(), own.size(), owner);
        std::ranges::move(own, std::back_inserter(changed.path));
    }
    paths = std::move(changed);
    return any;
}

/// Calls `change` for the subpaths with selected nodes, or for all if no node is selected.
template <class Change>
bool ofChosen(NodePath& path, const Change& change)
{
    const bool all = selectedCount(path) == 0;
    bool any = false;
    for (NodeSubpath& subpath : path)
        if (all || std::ranges::any_of(subpath.nodes, &Node::selected))
            any |= change(subpath);
    return any;
}

bool reverseChosen(OwnedPaths& paths, const JoinRule&)
{
    return ofChosen(paths.path, [](NodeSubpath& subpath) {
        reverse(subpath);
        return true;
    });
}

bool closeChosen(OwnedPaths& paths, const JoinRule&) { return ofChosen(paths.path, close); }

bool openChosen(OwnedPaths& paths, const JoinRule&)
{
    return ofChosen(paths.path, [](NodeSubpath& subpath) {
        const auto at = std::ranges::find_if(subpath.nodes, &Node::selected);
        const bool any = at != subpath.nodes.end();
        return open(subpath, any ? std::size_t(at - subpath.nodes.begin()) : 0);
    });
}

std::size_t openCount(const NodePath& path)
{
    return std::size_t(std::ranges::count_if(path, [](const NodeSubpath& subpath) {
        return !subpath.closed && subpath.nodes.size() > 1;
    }));
}

std::size_t objectCount(const OwnedPaths& paths)
{
    std::size_t count = 0;
    for (std::size_t i = 0; i < paths.owners.size(); ++i)
        count += i == 0 || paths.owners[i] != paths.owners[i - 1];
    return count;
}

// NOLINTNEXTLINE(readability-function-size): a table, a row for each step
std::array<NodeStep, 12> allSteps()
{
    return {
        NodeStep{"corner-nodes", Text::tr("Make nodes &corners"), Text::tr("Make nodes corners"),
                 true, endsHaveNoType, setType<NodeType::Corner>},
        NodeStep{"smooth-nodes", Text::tr("Make nodes &smooth"), Text::tr("Make nodes smooth"),
                 true, endsHaveNoType, setType<NodeType::Smooth>},
        NodeStep{"symmetric-nodes", Text::tr("Make nodes s&ymmetric"),
                 Text::tr("Make nodes symmetric"), true, endsHaveNoType,
                 setType<NodeType::Symmetric>},
        NodeStep{"straighten-segments", Text::tr("Turn segments into &lines"),
                 Text::tr("Turn segments into lines"), true,
                 [](const NodeSummary& nodes) {
                     return nodes.curved > 0     ? QString()
                            : nodes.straight > 0 ? Text::tr("The segments are straight already.")
                                                 : noSegment();
                 },
                 [](OwnedPaths& paths, const JoinRule&) { return makeStraight(paths.path); }},
        NodeStep{"curve-segments", Text::tr("Turn segments into c&urves"),
                 Text::tr("Turn segments into curves"), true,
                 [](const NodeSummary& nodes) {
                     return nodes.straight > 0 ? QString()
                            : nodes.curved > 0 ? Text::tr("The segments are curves already.")
                                               : noSegment();
                 },
                 [](OwnedPaths& paths, const JoinRule&) { return makeCurved(paths.path); }},
        NodeStep{"add-nodes", Text::tr("&Add nodes in the middle"), Text::tr("Add nodes"), true,
                 [](const NodeSummary& nodes) {
                     return nodes.straight + nodes.curved > 0 ? QString() : noSegment();
                 },
                 [](OwnedPaths& paths, const JoinRule&) { return insertInChosen(paths.path); }},
        NodeStep{"delete-nodes", Text::tr("&Delete nodes"), Text::tr("Delete nodes"), true, always,
                 ofEach<deleteSelected>},
        NodeStep{"split-path", Text::tr("Split path at &nodes"), Text::tr("Split path"), true,
                 [](const NodeSummary& nodes) {
                     return nodes.selected > nodes.selectedEnds
                                ? QString()
                                : Text::tr("The path ends here already. Select a node between two "
                                           "segments.");
                 },
                 ofEach<splitAtSelected>},
        NodeStep{"join-ends",
                 Text::tr("&Join ends…"),
                 Text::tr("Join ends"),
                 false,
                 [](const NodeSummary& nodes) {
                     return nodes.open > 0
                                ? QString()
                                : Text::tr("The path is closed: it has no ends to join.");
                 },
                 [](OwnedPaths& paths, const JoinRule& rule) {
                     return joinEnds(paths.path, paths.owners, rule.tolerance, rule.pens) > 0;
                 },
                 {},
                 true},
        NodeStep{"close-path", Text::tr("Cl&ose path"), Text::tr("Close path"), false,
                 [](const NodeSummary& nodes) {
                     return nodes.open > 0 ? QString() : Text::tr("The path is closed already.");
                 },
                 closeChosen, Text::tr("The path is closed already.")},
        NodeStep{"open-path", Text::tr("O&pen path"), Text::tr("Open path"), false,
                 [](const NodeSummary& nodes) {
                     return nodes.closed > 0 ? QString() : Text::tr("The path is open already.");
                 },
                 openChosen, Text::tr("The path is open already.")},
        NodeStep{"reverse-path", Text::tr("&Reverse path"), Text::tr("Reverse path"), false, always,
                 reverseChosen},
    };
}

} // namespace

std::span<const NodeStep> nodeSteps()
{
    // THE CATALOGUE. To add a step: add its row to allSteps(), and its row in
    // ui/menus/path_rows.cpp.
    static const std::array all = allSteps();
    return all;
}

const NodeStep& nodeStep(std::string_view key)
{
    return *std::ranges::find(nodeSteps(), key, &NodeStep::key);
}

QString joinedText(const OwnedPaths& before, const OwnedPaths& after, const QString& tolerance)
{
    const std::size_t joints = openCount(before.path) - openCount(after.path);
    const QString joined =
        joints == 1
            ? Text::tr("1 pair of ends was joined within %1.").arg(tolerance)
            : Text::tr("%1 pairs of ends were joined within %2.").arg(countText(joints), tolerance);
    const std::size_t objects = objectCount(before), left = objectCount(after);
    return left == objects ? joined
                           : Text::tr("%1 objects became %2: %3")
                                 .arg(countText(objects), countText(left), joined);
}

QString notJoinedText(const QString& tolerance)
{
    return Text::tr(
               "No two ends of the same layer and style lie within %1 of each other. Choose a "
               "larger distance, or select two ends with the tool Nodes to join them by a line.")
        .arg(tolerance);
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/node_editing.h"

#include "app/commands/change_paths.h"
#include "app/nodes/node_segments.h"
#include "app/session/session.h"

#include <QCoreApplication>

#include <algorithm>
#include <utility>

namespace app {
namespace {

bool sameShape(std::span<const NodeSubpath> a, std::span<const NodeSubpath> b)
{
    const auto sameNode = [](const Node& p, const Node& q) {
        return p.at == q.at && p.in == q.in && p.out == q.out && p.curved == q.curved;
    };
    return std::ranges::equal(a, b, [&](const NodeSubpath& p, const NodeSubpath& q) {
        return p.closed == q.closed && std::ranges::equal(p.nodes, q.nodes, sameNode);
    });
}

/// The subpaths of one object after the other.
class EachObject {
public:
    explicit EachObject(const OwnedPaths& paths) : paths_(paths) {}
    std::span<const NodeSubpath> of(std::size_t object)
    {
        const std::size_t first = next_;
        while (next_ < paths_.owners.size() && paths_.owners[next_] == object)
            ++next_;
        return std::span(paths_.path).subspan(first, next_ - first);
    }

private:
    const OwnedPaths& paths_;
    std::size_t next_ = 0;
};

/// The objects whose shape differs, with their new paths.
std::vector<ChangedPath> differing(const std::vector<std::size_t>& objects,
                                   const OwnedPaths& before, const OwnedPaths& after)
{
    std::vector<ChangedPath> changed;
    EachObject old(before), now(after);
    for (const std::size_t object : objects) {
        const auto subpaths = now.of(object);
        if (!sameShape(old.of(object), subpaths))
            changed.push_back({object, Path(subpathsOf(subpaths))});
    }
    return changed;
}

/// The numbers of the objects that stay after others were removed, which the owners get too.
std::vector<std::size_t> renumbered(const std::vector<std::size_t>& objects,
                                    const std::vector<ChangedPath>& changes,
                                    std::vector<std::size_t>& owners)
{
    std::vector<std::size_t> left;
    std::size_t gone = 0, owner = 0, change = 0;
    for (const std::size_t object : objects) {
        const bool changed = change < changes.size() && changes[change].object == object;
        if (changed && changes[change++].path.subpathCount() == 0)
            ++gone;
        else
            left.push_back(object - gone);
        for (; owner < owners.size() && owners[owner] == object; ++owner)
            owners[owner] -= gone;
    }
    return left;
}

} // namespace

NodeEditing::NodeEditing(Session& session) : session_(session)
{
    const auto outdate = [this] {
        outdated_ = true;
        summary_.reset();
        if (shown_ && !applying_)
            emit changed();
    };
    connect(&session.document, &EditedDocument::changed, this,
            [outdate](const DocumentChange& change) {
                if (change.objects)
                    outdate();
            });
    connect(&session, &Session::selectionChanged, this, outdate);
}

void NodeEditing::setShown(bool shown)
{
    if (std::exchange(shown_, shown) == shown)
        return;
    selectAll(false);
}

const NodePath& NodeEditing::path() const
{
    if (outdated_)
        read();
    return read_.path;
}

const NodeSummary& NodeEditing::summary() const
{
    path();
    if (!summary_)
        summary_ = summaryOf(read_.path);
    return *summary_;
}

std::uint64_t NodeEditing::revision() const
{
    path();
    return revision_;
}

std::size_t NodeEditing::objectOf(std::size_t subpath) const
{
    path();
    return read_.owners[subpath];
}

void NodeEditing::read() const
{
    const ObjectRanges& selection = session_.selection();
    std::vector<std::size_t> objects;
    OwnedPaths paths;
    if (selection.size() <= mostObjects)
        for (const std::size_t object : selection) {
            objects.push_back(object);
            for (NodeSubpath& subpath :
                 nodesOf(session_.now().objects()[object].path().subpaths())) {
                paths.path.push_back(std::move(subpath));
                paths.owners.push_back(object);
            }
        }
    std::swap(read_, paths);
    if (std::exchange(objects_, std::move(objects)) == objects_)
        carryOver(paths);
    outdated_ = false;
    ++revision_;
    summary_.reset();
}

/// Subpaths with as many nodes as before are taken for the same: their nodes stay selected, and
/// those that have not changed keep their types.
void NodeEditing::carryOver(const OwnedPaths& before) const
{
    for (std::size_t s = 0; s < std::min(before.path.size(), read_.path.size()); ++s) {
        const auto& from = before.path[s].nodes;
        auto& to = read_.path[s].nodes;
        if (from.size() != to.size() || before.owners[s] != read_.owners[s])
            continue;
        for (std::size_t i = 0; i < to.size(); ++i) {
            to[i].selected = from[i].selected;
            if (from[i].at == to[i].at && from[i].in == to[i].in && from[i].out == to[i].out)
                to[i].type = from[i].type;
        }
    }
}

void NodeEditing::selectAll(bool selected)
{
    select([&](NodePath& path) { app::selectAll(path, selected); });
}

void NodeEditing::selectOnly(const NodeAddress& node)
{
    select([&](NodePath& path) {
        app::selectAll(path, false);
        path[node.subpath].nodes[node.node].selected = true;
    });
}

void NodeEditing::selectNeighbour(bool forwards)
{
    std::optional<NodeAddress> last;
    for (std::size_t s = 0; s < path().size(); ++s)
        for (std::size_t i = 0; i < path()[s].nodes.size(); ++i)
            if (path()[s].nodes[i].selected && (forwards || !last))
                last = NodeAddress{s, i};
    if (const auto next = neighbour(path(), last, forwards))
        selectOnly(*next);
}

bool NodeEditing::refuse(const QString& sentence)
{
    emit session_.refused(sentence);
    return false;
}

QString NodeEditing::lockedSentence(std::size_t object) const
{
    const Containers& containers = session_.now().containers();
    return tr("The layer %1 is locked or hidden. Unlock and show it to change its paths.")
        .arg(containers[containers.layerOf(object)].name);
}

QString NodeEditing::whyNotEditable(const OwnedPaths& paths) const
{
    for (const std::size_t object : objects_)
        if (!session_.now().editable(object))
            return lockedSentence(object);
    if (!isFinite(paths.path))
        return tr("The nodes would lie too far away for any number. Nothing was changed.");
    return {};
}

bool NodeEditing::apply(OwnedPaths paths, const QString& done, Merging merging)
{
    path();
    if (paths.owners.size() != paths.path.size())
        return false; // made from nodes that have changed since
    if (const QString why = whyNotEditable(paths); !why.isEmpty())
        return refuse(why);
    const std::vector<ChangedPath> changes = differing(objects_, read_, paths);
    std::vector<std::size_t> objects = objects_;
    applying_ = true;
    if (!changes.empty())
        session_.history.push(new ChangePaths(session_.document, changes, done, merging));
    applying_ = false;
    objects = renumbered(objects, changes, paths.owners);
    read_ = std::move(paths);
    objects_ = std::move(objects);
    outdated_ = true; // to be compared with the document, and then the same nodes stay selected
    summary_.reset();
    emit changed();
    return true;
}

bool NodeEditing::apply(NodePath changed, const QString& done, Merging merging)
{
    path();
    return apply({std::move(changed), read_.owners}, done, merging);
}

bool NodeEditing::move(const Point& by, Merging merging)
{
    NodePath moved = path();
    return moveSelected(moved, by) ? apply(std::move(moved), tr("Move nodes"), merging)
                                   : refuse(tr("This is no distance for nodes."));
}

bool NodeEditing::moveTo(const NodeAddress& node, const Point& to)
{
    NodePath moved = path();
    return moveSelectedTo(moved, node, to) ? apply(std::move(moved), tr("Move nodes"))
                                           : refuse(tr("This is no place for a node."));
}

bool NodeEditing::insert(const NodeAddress& segment, double t)
{
    NodePath more = path();
    app::selectAll(more, false);
    const auto added = insertNode(more[segment.subpath], segment.node, t);
    if (!added)
        return false;
    more[segment.subpath].nodes[*added].selected = true;
    return apply(std::move(more), tr("Add node"));
}

QString NodeEditing::refusal(const NodeStep& step) const
{
    const ObjectRanges& selection = session_.selection();
    if (selection.empty())
        return tr("Nothing is selected. Select a path first.");
    if (selection.size() > mostObjects)
        return tr("More than %L1 objects are selected. Select fewer of them.").arg(mostObjects);
    if (!session_.now().editable(selection.first()))
        return lockedSentence(selection.first());
    if (step.needsNodes && !someSelected())
        return shown_ ? tr("No node is selected. Click a node, or press Tab.")
                      : tr("Choose the tool Nodes (N) and select a node first.");
    // Without the tool, nodes are read only when the step is taken.
    return shown_ || !outdated_ ? step.refusal(summary()) : QString();
}

bool NodeEditing::run(const NodeStep& step)
{
    path();
    if (const QString why = refusal(step); !why.isEmpty())
        return refuse(why);
    OwnedPaths paths = read_;
    if (!step.change(paths, joiningMillimetres / session_.now().page().millimetresPerUnit()))
        return step.refused.isEmpty() || refuse(step.refused);
    return apply(std::move(paths), step.done);
}

} // namespace app

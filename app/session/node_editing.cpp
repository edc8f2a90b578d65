// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/node_editing.h"

#include "app/base/keys_in_use.h"
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/commands/change_paths.h"
#include "app/nodes/node_segments.h"
#include "app/session/session.h"

#include <QScopedValueRollback>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>
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
    return Text::tr("The layer %1 is locked or hidden. Unlock and show it to change its paths.")
        .arg(containers[containers.layerOf(object)].name);
}

QString NodeEditing::whyNotEditable(const OwnedPaths& paths) const
{
    for (const std::size_t object : objects_)
        if (!session_.now().editable(object))
            return lockedSentence(object);
    if (!isFinite(paths.path))
        return Text::tr("The nodes would lie too far away for any number. Nothing was changed.");
    return {};
}

/// Returns why the nodes cannot be replaced; empty: they are.
QString NodeEditing::put(OwnedPaths paths, const QString& done, Merging merging)
{
    if (const QString why = whyNotEditable(paths); !why.isEmpty())
        return why;
    const std::vector<ChangedPath> changes = differing(objects_, read_, paths);
    std::vector<std::size_t> objects = objects_;
    {
        const QScopedValueRollback applying(applying_, true);
        if (!changes.empty())
            session_.history.push(new ChangePaths(session_.document, changes, done, merging));
    }
    objects = renumbered(objects, changes, paths.owners);
    read_ = std::move(paths);
    objects_ = std::move(objects);
    outdated_ = true; // to be compared with the document, and then the same nodes stay selected
    summary_.reset();
    emit changed();
    return {};
}

bool NodeEditing::apply(OwnedPaths paths, const QString& done, Merging merging)
{
    path();
    if (paths.owners.size() != paths.path.size())
        return false; // made from nodes that have changed since
    const QString why = put(std::move(paths), done, merging);
    return why.isEmpty() || refuse(why);
}

bool NodeEditing::apply(NodePath changed, const QString& done, Merging merging)
{
    path();
    return apply({std::move(changed), read_.owners}, done, merging);
}

bool NodeEditing::move(const Point& by, Merging merging)
{
    NodePath moved = path();
    return moveSelected(moved, by) ? apply(std::move(moved), Text::tr("Move nodes"), merging)
                                   : refuse(Text::tr("This is no distance for nodes."));
}

bool NodeEditing::moveTo(const NodeAddress& node, const Point& to)
{
    NodePath moved = path();
    return moveSelectedTo(moved, node, to) ? apply(std::move(moved), Text::tr("Move nodes"))
                                           : refuse(Text::tr("This is no place for a node."));
}

bool NodeEditing::insert(const NodeAddress& segment, double t)
{
    NodePath more = path();
    app::selectAll(more, false);
    const auto added = insertNode(more[segment.subpath], segment.node, t);
    if (!added)
        return false;
    more[segment.subpath].nodes[*added].selected = true;
    return apply(std::move(more), Text::tr("Add node"));
}

QString NodeEditing::refusal(const NodeStep& step) const
{
    const ObjectRanges& selection = session_.selection();
    if (selection.empty())
        return Text::tr("Nothing is selected. Select a path first.");
    if (selection.size() > mostObjects)
        return Text::tr("More than %L1 objects are selected. Select fewer of them.")
            .arg(mostObjects);
    if (!session_.now().editable(selection.first()))
        return lockedSentence(selection.first());
    if (step.needsNodes && !someSelected())
        return shown_ ? Text::tr("No node is selected. Click a node, or press Tab.")
                      : withKeys(Text::tr(
                          "Choose the tool Nodes ({tool-nodes}) and select a node first."));
    // Without the tool, nodes are read only when the step is taken.
    return shown_ || !outdated_ ? step.refusal(summary()) : QString();
}

/// Ends are joined within a layer and a style.
JoinRule NodeEditing::joinRule() const
{
    const Document& now = session_.now();
    JoinRule rule{session_.arrange.joinWithin / now.page().millimetresPerUnit()};
    std::map<std::pair<ContainerId, StyleIndex>, std::uint32_t> pens;
    for (const std::size_t object : read_.owners) {
        const std::pair pen(now.containers().layerOf(object), now.objects()[object].styleIndex());
        rule.pens.push_back(pens.try_emplace(pen, std::uint32_t(pens.size())).first->second);
    }
    return rule;
}

QString NodeEditing::whyNotJoined(const JoinRule& rule) const
{
    std::set<std::uint32_t> pens; // of the selected ends
    for (std::size_t i = 0; i < read_.path.size(); ++i) {
        const NodeSubpath& subpath = read_.path[i];
        for (std::size_t k = 0; k < subpath.nodes.size(); ++k)
            if (subpath.nodes[k].selected && subpath.isEnd(k))
                pens.insert(rule.pens[i]);
    }
    return pens.size() > 1
               ? Text::tr("The selected ends belong to several layers or styles, and are not "
                          "joined. Give the paths the same layer and style first.")
               : notJoinedText(toleranceText());
}

/// With as few decimals as tell it to a hundredth of itself: "0.1 mm".
QString NodeEditing::toleranceText() const
{
    constexpr int mostDecimals = 6;
    const Page& page = session_.now().page();
    const Unit unit = page.paperUnit(session_.display().unit);
    const double millimetres = page.millimetresPerUnit();
    const double length = inUnit(session_.arrange.joinWithin / millimetres, unit, millimetres);
    int decimals = 0;
    for (double tens = 1; decimals < mostDecimals; ++decimals, tens *= 10)
        if (std::abs(std::round(length * tens) / tens - length) <= 0.01 * length)
            break;
    const std::string_view suffix = infoOf(unit).suffix;
    const QString number = numberText(length, decimals);
    return suffix.empty() ? number : number + u' ' + QString::fromUtf8(suffix);
}

bool NodeEditing::asksTolerance(const NodeStep& step) const
{
    return step.joins && !(shown_ && summary().selectedEnds == 2);
}

Result<QString> NodeEditing::tried(const NodeStep& step)
{
    using Done = Result<QString>;
    path();
    if (const QString why = refusal(step); !why.isEmpty())
        return Done::failure(why);
    OwnedPaths paths = read_;
    const JoinRule rule = step.joins ? joinRule() : JoinRule{};
    if (!step.change(paths, rule))
        return step.joins               ? Done::failure(whyNotJoined(rule))
               : step.refused.isEmpty() ? Done::of({})
                                        : Done::failure(step.refused);
    const QString done =
        asksTolerance(step) ? joinedText(read_, paths, toleranceText()) : QString();
    const QString why = put(std::move(paths), step.done, Merging::Never);
    return why.isEmpty() ? Done::of(done) : Done::failure(why);
}

bool NodeEditing::run(const NodeStep& step)
{
    const auto done = tried(step);
    return done || refuse(done.error);
}

} // namespace app

#include "moc_node_editing.cpp"

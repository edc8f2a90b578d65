// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/named_things.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/session/units.h"
#include "app/session/window_words.h"

#include <algorithm>

namespace app {
namespace {

using ThingKind = NamedThing::Kind;
using std::chrono::steady_clock;

QString remarkOn(const Containers& tree, ContainerId id)
{
    return !tree.shown(id) ? Text::tr("hidden") : tree.locked(id) ? Text::tr("locked") : QString();
}

void addWindows(const Session& session, const QString& typed, std::vector<NamedThing>& things)
{
    const auto& windows = session.windows().list;
    for (std::size_t i = 0; i < windows.size(); ++i)
        if (auto match = matchName(typed, nameOf(windows[i])))
            things.push_back({ThingKind::Window, i, nameOf(windows[i]), Text::tr("clip window"),
                              windows[i].visible ? QString() : Text::tr("hidden"),
                              std::move(*match)});
}

void addContainers(const Session& session, const QString& typed, std::vector<NamedThing>& things)
{
    const Containers& tree = session.now().containers();
    for (const ContainerId id : tree.inOrder()) {
        const Container& container = tree[id];
        const bool isLayer = container.kind == Container::Kind::Layer;
        const QString name = isLayer ? container.name : groupName(container);
        auto match = matchName(typed, name);
        if (!match)
            continue;
        const QString count = countText(tree.rangeOf(id).size());
        things.push_back(
            {isLayer ? ThingKind::Layer : ThingKind::Group, id, name,
             (isLayer ? Text::tr("layer, %1 objects") : Text::tr("group, %1 objects")).arg(count),
             remarkOn(tree, id), std::move(*match)});
    }
}

const QString& nameIn(const Particulars& particulars)
{
    return particulars.id.isEmpty() ? particulars.title : particulars.id;
}

/// Whether all were looked at.
bool addObjects(const Session& session, const QString& typed, std::size_t most,
                steady_clock::time_point end, std::vector<NamedThing>& things)
{
    constexpr std::size_t atOnce = 4096;
    const QString text = typed.simplified();
    const Objects& objects = session.now().objects();
    const Containers& tree = session.now().containers();
    for (std::size_t first = 0; first < objects.size(); first += atOnce) {
        if (things.size() >= most || steady_clock::now() > end)
            return false;
        const std::size_t count = std::min(atOnce, objects.size() - first);
        objects.forEach(first, count, [&](std::size_t i, const ObjectView& object) {
            const QString& name = nameIn(object.particulars());
            if (name.isEmpty() || !name.contains(text, Qt::CaseInsensitive)
                || things.size() >= most)
                return;
            const ContainerId layer = tree.layerOf(i);
            things.push_back(
                {ThingKind::Object, i, name, Text::tr("object in %1").arg(tree[layer].name),
                 object.hidden() ? Text::tr("hidden") : remarkOn(tree, tree.containerOf(i)),
                 matchName(text, name).value_or(NameMatch{})});
        });
    }
    return true;
}

ObjectRanges objectsOf(const Session& session, const NamedThing& thing)
{
    if (thing.kind != ThingKind::Object) {
        const Containers& tree = session.now().containers();
        const auto id = ContainerId(thing.number);
        return tree.contains(id) ? ObjectRanges(tree.rangeOf(id)) : ObjectRanges();
    }
    const bool exists = thing.number < session.now().objects().size();
    return exists ? ObjectRanges(ObjectRange{thing.number, thing.number + 1}) : ObjectRanges();
}

bool chooseWindowNamed(Session& session, const NamedThing& thing)
{
    const auto& list = session.windows().list;
    if (thing.number >= list.size())
        return false;
    if (!list[thing.number].visible) {
        emit session.refused(
            Text::tr("The clip window %1 is hidden. Show it first.").arg(thing.name));
        return false;
    }
    session.chooseWindow(thing.number);
    return true;
}

} // namespace

NamedThings thingsNamed(const Session& session, const QString& typed, std::size_t most,
                        std::chrono::microseconds time)
{
    const auto end = steady_clock::now() + time;
    NamedThings found;
    if (typed.trimmed().isEmpty())
        return found;
    addWindows(session, typed, found.list);
    addContainers(session, typed, found.list);
    std::ranges::stable_sort(found.list, std::greater(),
                             [](const NamedThing& thing) { return thing.match.score; });
    if (found.list.size() > most)
        found.list.erase(found.list.begin() + std::ptrdiff_t(most), found.list.end());
    found.isAll = addObjects(session, typed, most, end, found.list);
    return found;
}

bool chooseThing(Session& session, const NamedThing& thing)
{
    if (thing.kind == ThingKind::Window)
        return chooseWindowNamed(session, thing);
    session.entered.enter(0);
    ObjectRanges objects = common(objectsOf(session, thing), selectableObjects(session));
    if (objects.empty()) {
        emit session.refused(
            Text::tr("%1 is empty, locked or hidden. Unlock and show it first.").arg(thing.name));
        return false;
    }
    session.select(std::move(objects));
    return true;
}

} // namespace app

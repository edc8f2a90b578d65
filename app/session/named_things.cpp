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

QString nameOf(const Container& container)
{
    return container.kind == Container::Kind::Layer ? container.name : groupName(container);
}

/// The best of them; whether all were looked at.
bool addContainers(const Session& session, const QString& typed, std::size_t most,
                   steady_clock::time_point end, std::vector<NamedThing>& things)
{
    constexpr std::size_t atOnce = 512;
    const Containers& tree = session.now().containers();
    std::vector<std::pair<ContainerId, NameMatch>> found;
    std::size_t looked = 0;
    const auto all = tree.inOrder();
    for (; looked < all.size(); ++looked) {
        if (looked % atOnce == 0 && steady_clock::now() > end)
            break;
        if (auto match = matchName(typed, nameOf(tree[all[looked]])))
            found.emplace_back(all[looked], std::move(*match));
    }
    std::ranges::stable_sort(found, std::greater(),
                             [](const auto& one) { return one.second.score; });
    found.resize(std::min(found.size(), most));
    for (auto& [id, match] : found) {
        const bool isLayer = tree[id].kind == Container::Kind::Layer;
        const std::size_t count = tree.rangeOf(id).size();
        const QString what = isLayer ? Text::tr("layer, %1") : Text::tr("group, %1");
        const QString objects = count == 1 ? Text::tr("1 object") : Text::tr("%1 objects");
        things.push_back({isLayer ? ThingKind::Layer : ThingKind::Group, id, nameOf(tree[id]),
                          what.arg(count == 1 ? objects : objects.arg(countText(count))),
                          remarkOn(tree, id), std::move(match)});
    }
    return looked == all.size();
}

/// Its id or title, else what it is called.
QString nameOfObject(const Session& session, std::size_t object, const ObjectView& view)
{
    const Particulars& particulars = view.particulars();
    return !particulars.id.isEmpty()      ? particulars.id
           : !particulars.title.isEmpty() ? particulars.title
                                          : objectName(session, object);
}

/// Whether it has a name of its own. Others are looked at only if a number is typed: "line" would
/// find all lines.
bool isNamed(const ObjectView& view)
{
    return !view.particulars().id.isEmpty() || !view.particulars().title.isEmpty();
}

/// Whether all were looked at.
bool addObjects(const Session& session, const QString& typed, std::size_t most,
                steady_clock::time_point end, std::vector<NamedThing>& things)
{
    constexpr std::size_t atOnce = 4096;
    const Objects& objects = session.now().objects();
    const Containers& tree = session.now().containers();
    const bool hasNumber = std::ranges::any_of(typed, [](QChar c) { return c.isDigit(); });
    for (std::size_t first = 0; first < objects.size(); first += atOnce) {
        if (things.size() >= most || steady_clock::now() > end)
            return false;
        const std::size_t count = std::min(atOnce, objects.size() - first);
        objects.forEach(first, count, [&](std::size_t i, const ObjectView& object) {
            if (things.size() >= most || (!hasNumber && !isNamed(object)))
                return;
            const QString name = nameOfObject(session, i, object);
            if (isNamed(object) ? !name.contains(typed, Qt::CaseInsensitive)
                                : !objectNameHas(session, i, typed))
                return;
            const ContainerId layer = tree.layerOf(i);
            things.push_back(
                {ThingKind::Object, i, name, Text::tr("object in %1").arg(tree[layer].name),
                 object.hidden() ? Text::tr("hidden") : remarkOn(tree, tree.containerOf(i)),
                 matchName(typed, name).value_or(NameMatch{})});
        });
    }
    return true;
}

/// Empty: it is gone, or has another name now.
ObjectRanges objectsOf(const Session& session, const NamedThing& thing)
{
    const Containers& tree = session.now().containers();
    const Objects& objects = session.now().objects();
    const auto id = ContainerId(thing.number);
    if (thing.kind != ThingKind::Object)
        return tree.contains(id) && nameOf(tree[id]) == thing.name ? ObjectRanges(tree.rangeOf(id))
                                                                   : ObjectRanges();
    return thing.number < objects.size()
                   && nameOfObject(session, thing.number, objects[thing.number]) == thing.name
               ? ObjectRanges(ObjectRange{thing.number, thing.number + 1})
               : ObjectRanges();
}

bool chooseWindowNamed(Session& session, const NamedThing& thing)
{
    const auto& list = session.windows().list;
    if (thing.number >= list.size() || nameOf(list[thing.number]) != thing.name)
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
    const auto begin = steady_clock::now();
    const QString text = typed.simplified();
    NamedThings found;
    addWindows(session, text, found.list);
    std::ranges::stable_sort(found.list, std::greater(),
                             [](const NamedThing& thing) { return thing.match.score; });
    // Each kind has its share of places and time: many layers hide no object.
    const std::size_t share = most / 3;
    found.list.resize(std::min(found.list.size(), share));
    const bool containers = addContainers(session, text, share, begin + time / 2, found.list);
    // Nothing typed: no list of all objects.
    const bool objects =
        text.isEmpty() || addObjects(session, text, most, begin + time, found.list);
    found.isAll = containers && objects;
    return found;
}

bool chooseThing(Session& session, const NamedThing& thing)
{
    if (thing.kind == ThingKind::Window)
        return chooseWindowNamed(session, thing);
    const ContainerId before = session.entered.id();
    session.entered.enter(0);
    ObjectRanges objects = common(objectsOf(session, thing), selectableObjects(session));
    if (objects.empty()) {
        session.entered.enter(before);
        emit session.refused(
            Text::tr("%1 is empty, locked or hidden. Unlock and show it first.").arg(thing.name));
        return false;
    }
    session.select(std::move(objects));
    return true;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/select_alike.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/session/units.h"

#include <algorithm>
#include <array>
#include <bit>
#include <unordered_set>

namespace app {
namespace {

/// Calls visit(object, style) for the objects.
template <class Visit>
void forEachStyle(const Objects& objects, const ObjectRanges& some, const Visit& visit)
{
    for (const ObjectRange& range : some.ranges())
        objects.forEach(range.first, range.size(), [&](std::size_t i, const ObjectView& object) {
            visit(i, object.styleIndex());
        });
}

/// Objects whose style has a key that a selected style has, too. Each style is looked at once.
template <class KeyOf>
ObjectRanges likeBy(const Session& session, const KeyOf& keyOf)
{
    const Objects& objects = session.now().objects();
    const StyleTable& styles = session.now().styles();
    enum class Is : std::uint8_t { Unknown, Like, Unlike };
    std::vector<Is> known(styles.size());
    std::unordered_set<decltype(keyOf(styles[0], StyleIndex(0)))> wanted;
    forEachStyle(objects, session.selection(), [&](std::size_t, StyleIndex style) {
        if (std::exchange(known[style], Is::Like) != Is::Like)
            wanted.insert(keyOf(styles[style], style));
    });
    ObjectRanges like;
    const ObjectRanges all(ObjectRange{0, objects.size()});
    forEachStyle(objects, all, [&](std::size_t i, StyleIndex style) {
        if (known[style] == Is::Unknown)
            known[style] = wanted.contains(keyOf(styles[style], style)) ? Is::Like : Is::Unlike;
        if (known[style] == Is::Like)
            like.insert(ObjectRange{i, i + 1});
    });
    return like;
}

ObjectRanges sameColour(const Session& session)
{
    return likeBy(session, [](const Style& style, StyleIndex) {
        const auto& colour = style.stroke ? style.stroke : style.fill;
        return colour ? std::optional(std::bit_cast<std::uint32_t>(*colour)) : std::nullopt;
    });
}

ObjectRanges sameWidth(const Session& session)
{
    return likeBy(session, [](const Style& style, StyleIndex) {
        return style.stroke ? std::optional(style.width) : std::nullopt;
    });
}

ObjectRanges sameStyle(const Session& session)
{
    return likeBy(session, [](const Style&, StyleIndex style) { return style; });
}

ObjectRanges sameLayer(const Session& session)
{
    const Containers& tree = session.now().containers();
    ObjectRanges layers;
    for (const ObjectRange& range : session.selection().ranges())
        for (std::size_t i = range.first; i < range.end;) {
            const ObjectRange layer = tree.rangeOf(tree.layerOf(i));
            layers.insert(layer);
            i = layer.end; // layers nested in it are found, too
        }
    return layers;
}

bool isPartOf(const QString& name, const QString& text)
{
    return name.contains(text, Qt::CaseInsensitive);
}

/// All objects of which `has(name)` is true for an id, a title, or the id or name of a container
/// around them.
template <class Has>
ObjectRanges named(const Document& document, const Has& has)
{
    ObjectRanges found;
    const Containers& tree = document.containers();
    for (const ContainerId id : tree.inOrder())
        if (has(tree[id].svgId) || has(tree[id].name))
            found.insert(tree.rangeOf(id));
    const Objects& objects = document.objects();
    objects.forEach(0, objects.size(), [&](std::size_t i, const ObjectView& object) {
        const Particulars& particulars = object.particulars();
        if (has(particulars.id) || has(particulars.title))
            found.insert(i);
    });
    return found;
}

} // namespace

std::span<const Likeness> likenesses()
{
    static const std::array all{
        Likeness{"same-colour", Text::tr("Same &colour"), sameColour},
        Likeness{"same-stroke-width", Text::tr("Same stroke &width"), sameWidth},
        Likeness{"same-style", Text::tr("Same &style"), sameStyle},
        Likeness{"same-layer", Text::tr("Same &layer"), sameLayer},
    };
    return all;
}

void selectAlike(Session& session, const Likeness& likeness)
{
    session.select(common(likeness.like(session), selectableObjects(session)));
}

void invertSelection(Session& session)
{
    session.select(without(selectableObjects(session), session.selection()));
}

void selectLayer(Session& session, ContainerId layer)
{
    const Containers& tree = session.now().containers();
    session.entered.enter(0);
    if (!tree.shown(layer) || tree.locked(layer))
        emit session.refused(
            Text::tr("The layer %1 is locked or hidden, so nothing in it was selected. "
                     "Unlock and show it first.")
                .arg(tree[layer].name));
    else
        session.select(common(ObjectRanges(tree.rangeOf(layer)), selectableObjects(session)));
}

QString find(Session& session, const QString& text)
{
    const QString wanted = text.trimmed();
    if (wanted.isEmpty())
        return Text::tr("Type an id or a name.");
    ObjectRanges found = named(session.now(), [&](const QString& name) { return name == wanted; });
    if (found.empty())
        found = named(session.now(), [&](const QString& name) { return isPartOf(name, wanted); });
    if (found.empty())
        return Text::tr("No object, group or layer is named “%1”.").arg(wanted);
    session.entered.enter(0);
    ObjectRanges usable = common(found, selectableObjects(session));
    if (usable.empty())
        return Text::tr("The objects named “%1” are locked or hidden. Unlock and show them first.")
            .arg(wanted);
    const std::size_t count = usable.size();
    session.select(std::move(usable));
    return count == 1 ? Text::tr("1 object is selected.")
                      : Text::tr("%1 objects are selected.").arg(countText(count));
}

} // namespace app

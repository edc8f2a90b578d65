// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/tree_search.h"

#include "app/base/numbers.h"
#include "app/session/units.h"
#include "app/session/window_words.h"

#include <algorithm>
#include <set>

namespace app {
namespace {

constexpr int mostWords = 16;
constexpr std::size_t slice = 512; // between two looks at the clock

QString nameIn(const Container& container)
{
    return container.kind == Container::Kind::Layer ? container.name : groupName(container);
}

} // namespace

TreeSearch::TreeSearch(const Session& session, const QString& typed)
    : session_(session),
      words_(typed.simplified().split(u' ', Qt::SkipEmptyParts).mid(0, mostWords)),
      all_((Words(1) << words_.size()) - 1),
      hasDigits_(std::ranges::any_of(typed, [](QChar c) { return c.isDigit(); })),
      containers_(session.now().containers().inOrder()), objects_(session.now().objects().size())
{
}

bool TreeSearch::advance(std::chrono::microseconds time)
{
    const auto end = std::chrono::steady_clock::now() + time;
    do {
        if (!containers_.empty())
            lookAtContainers(slice);
        else
            lookAtObjects(slice);
    } while (!isDone() && std::chrono::steady_clock::now() < end);
    return isDone();
}

TreeSearch::Words TreeSearch::wordsIn(const QString& name) const
{
    Words found = 0;
    for (qsizetype i = 0; i < words_.size(); ++i)
        if (name.contains(words_[i], Qt::CaseInsensitive))
            found |= Words(1) << i;
    return found;
}

TreeSearch::Words TreeSearch::wordsAround(ContainerId id)
{
    if (id == 0)
        return 0;
    if (const auto known = around_.find(id); known != around_.end())
        return known->second;
    const Containers& tree = session_.now().containers();
    const Words words = wordsIn(nameIn(tree[id])) | wordsAround(tree.parentOf(id));
    around_.emplace(id, words);
    return words;
}

/// In the object's name, as objectName() says it. Most names are a kind and a number, so the kind
/// is looked at once, and a number only if one was typed.
TreeSearch::Words TreeSearch::wordsOf(std::size_t object, const ObjectView& view)
{
    const Particulars& particulars = view.particulars();
    if (!particulars.id.isEmpty())
        return wordsIn(particulars.id) | wordsIn(particulars.title);
    const auto [kind, isNew] = ofKinds_.try_emplace(iconOf(view));
    if (isNew)
        kind->second = wordsIn(nameOf(view));
    Words words = kind->second;
    if (hasDigits_) { // "12,345" is typed with or without the comma
        const std::uint32_t number = session_.document.numbers().of(object);
        words |= wordsIn(countText(number)) | wordsIn(QString::number(number));
    }
    return particulars.title.isEmpty() ? words : words | wordsIn(particulars.title);
}

void TreeSearch::lookAtContainers(std::size_t count)
{
    const Containers& tree = session_.now().containers();
    for (; count > 0 && !containers_.empty(); --count) {
        const ContainerId id = containers_.back();
        containers_.pop_back();
        const bool isGroup = tree[id].kind == Container::Kind::Group;
        const Words own = wordsIn(nameIn(tree[id]));
        // A layer is not found because of the layer around it: it has its row anyway.
        if (own == 0 || (isGroup ? wordsAround(id) : own) != all_)
            continue;
        ++found_;
        if (foundContainers_.size() < mostKept)
            foundContainers_.push_back(id);
    }
}

void TreeSearch::lookAtObjects(std::size_t count)
{
    const std::size_t first = objects_ - std::min(count, objects_);
    const auto kept = std::ptrdiff_t(foundObjects_.size());
    session_.now().objects().forEach(
        first, objects_ - first, [&](std::size_t i, const ObjectView& view) {
            const Words own = wordsOf(i, view);
            if (own != all_
                && (own | wordsAround(session_.now().containers().containerOf(i))) != all_)
                return;
            ++found_;
            foundObjects_.push_back(i);
        });
    std::reverse(foundObjects_.begin() + kept, foundObjects_.end());
    foundObjects_.resize(std::min(foundObjects_.size(), mostKept));
    objects_ = first;
}

std::vector<TreeRow> TreeSearch::rows(std::size_t most) const
{
    const Containers& tree = session_.now().containers();
    std::set<ContainerId> shown; // what is found, and what is around it
    const auto show = [&](ContainerId id) {
        while (id != 0 && shown.insert(id).second)
            id = tree.parentOf(id);
    };
    for (std::size_t i = 0; i < std::min(most, foundContainers_.size()); ++i)
        show(foundContainers_[i]);
    const std::size_t room = most - std::min(most, foundContainers_.size());
    const auto objects = std::span(foundObjects_).first(std::min(room, foundObjects_.size()));
    for (const std::size_t object : objects)
        show(tree.containerOf(object));
    std::vector<ContainerId> containers(shown.begin(), shown.end());
    std::ranges::sort(containers,
                      [&](ContainerId a, ContainerId b) { return tree.endsBefore(b, a); });
    std::vector<TreeRow> rows;
    auto object = objects.begin();
    const auto addObjectsFrom = [&](std::size_t end) {
        for (; object != objects.end() && *object >= end; ++object) {
            const ContainerId around = tree.containerOf(*object);
            rows.push_back({TreeRow::Kind::Object, around, *object, tree.depthOf(around) + 1});
        }
    };
    for (const ContainerId id : containers) { // those that end further up come first
        addObjectsFrom(tree.rangeOf(id).end);
        rows.push_back(
            {tree[id].kind == Container::Kind::Layer ? TreeRow::Kind::Layer : TreeRow::Kind::Group,
             id, 0, tree.depthOf(id)});
    }
    addObjectsFrom(0);
    return rows;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/container_splicing.h"
#include "app/document/containers.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <utility>

namespace app {
namespace {

ContainerMark withObjects(ContainerMark mark, std::size_t objects)
{
    mark.objects = std::uint32_t(objects);
    return mark;
}

} // namespace

Containers Containers::with(const Container& changed) const
{
    assert(changed.id != 0 && changed.kind == (*this)[changed.id].kind);
    Containers tree = *this;
    tree.table_.setContainer(changed);
    return tree;
}

Containers Containers::spliced(std::size_t first, std::size_t removed, std::size_t added,
                               ContainerId into) const
{
    assert(first + removed <= objects() && (into != 0 || added == 0));
    return splicedWhere(touching(first, first + removed), [&](ContainerSplicing& marks) {
        marks.exchange(first, removed, added, into);
    });
}

Containers Containers::spliced(std::span<const Splice> splices, ContainerId into) const
{
    return splicedInto(splices, [&](std::size_t) { return into; });
}

Containers Containers::spliced(std::span<const Splice> splices,
                               std::span<const ContainerId> into) const
{
    assert(splices.size() == into.size());
    return splicedInto(splices, [&](std::size_t i) { return into[i]; });
}

// into(i): the container for the objects of splice i if it removes none.
template <class Into>
Containers Containers::splicedInto(std::span<const Splice> splices, const Into& into) const
{
    if (splices.empty())
        return *this;
    const Splice& last = splices.back();
    const auto [from, to] = touching(splices.front().first, std::size_t(last.first) + last.removed);
    if (splices.size() > 1 && splices.size() < to.block - from.block) { // most blocks stay
        Containers tree = *this;
        for (std::size_t i = splices.size(); i-- > 0;)
            tree = tree.spliced(splices.subspan(i, 1), into(i));
        return tree;
    }
    return splicedWhere({from, to}, [&](ContainerSplicing& marks) {
        for (std::size_t i = splices.size(); i-- > 0;)
            marks.splice(splices[i], into(i));
    });
}

// The range of marks that touch the objects [first, end), up to the first mark that keeps objects
// above them.
std::pair<Containers::At, Containers::At> Containers::touching(std::size_t first,
                                                               std::size_t end) const
{
    return {first > 0 ? marks_.before(first - 1) : marks_.begin(),
            end < objects() ? marks_.next(marks_.before(end)) : marks_.end()};
}

template <class Edit>
Containers Containers::splicedWhere(const std::pair<At, At>& where, const Edit& edit) const
{
    const auto& [from, to] = where;
    std::vector<ContainerMark> marks;
    for (At at = from; at != to; at = marks_.next(at))
        marks.push_back(marks_[at]);
    ContainerSplicing splicing(table_, std::move(marks), marks_.objectsBefore(to));
    edit(splicing);
    Containers tree = *this;
    if (!splicing.changed())
        return tree;
    std::vector<ContainerId> gone;
    tree.marks_.replace(from, to, splicing.take(gone));
    for (const ContainerId id : gone)
        tree.forget(id);
    return tree;
}

std::optional<Containers> Containers::inserted(Container container, ContainerId parent,
                                               std::size_t at, const ObjectRange& range) const
{
    assert(table_.mayHold(parent, container.kind));
    const auto children = childrenOf(parent);
    assert(at <= children.size());
    std::size_t end = at; // the end of the children that it takes over
    int height = 0;       // the largest height among them
    for (; end < children.size() && rangeOf(children[end]).first < range.end; ++end)
        height = std::max(height, heightOf(children[end]));
    if (count_ == mostContainers || depthOf(parent) + 1 + height > deepest)
        return std::nullopt;

    Containers tree = *this;
    const ContainerId id = tree.table_.add(std::move(container), parent);
    for (std::size_t i = at; i < end; ++i) {
        assert(tree.table_.mayHold(id, (*this)[children[i]].kind));
        tree.table_.own(children[i]).parent = id;
    }
    ++tree.count_;
    const auto below = [&](std::size_t child) { // the mark below that child
        return child == 0 ? tree.opening(parent) : tree.closing(children[child - 1]);
    };
    tree.giveLabels(id, below(at), below(end));
    tree.insertAt(below(end), range.end, {id, 1, 0});
    tree.insertAt(below(at), range.first, {id, 0, 0});
    return tree;
}

Containers Containers::dissolved(ContainerId id) const
{
    assert(parentOf(id) != 0);
    Containers tree = *this;
    for (const ContainerId child : childrenOf(id))
        tree.table_.own(child).parent = parentOf(id);
    tree.eraseMark(tree.closing(id));
    tree.eraseMark(tree.opening(id));
    tree.forget(id);
    return tree;
}

Containers Containers::removed(ContainerId id) const
{
    assert(id != 0);
    Containers tree = *this;
    const At first = marks_.previous(opening(id)), last = closing(id);
    for (At at = marks_.next(first); at != last; at = marks_.next(at))
        if (!marks_[at].closes)
            tree.forget(marks_[at].id);
    const ContainerMark below = marks_[first];
    const auto left = withObjects(below, below.objects + marks_[last].objects);
    tree.marks_.replace(first, marks_.next(last), std::span(&left, 1));
    assert(!tree.childrenOf(0).empty());
    return tree;
}

int Containers::heightOf(ContainerId id) const
{
    int height = 0, depth = 0;
    const At end = closing(id);
    for (At at = opening(id); at != end; at = marks_.next(at)) {
        depth += marks_[at].closes ? -1 : 1;
        height = std::max(height, depth);
    }
    return height;
}

void Containers::forget(ContainerId id)
{
    table_.remove(id);
    --count_;
}

// Inserts a mark among the objects that follow the mark at `at`, directly before the object number
// `object`.
void Containers::insertAt(const At& at, std::size_t object, ContainerMark mark)
{
    const ContainerMark below = marks_[at];
    const std::size_t before = object - marks_.objectsBefore(at);
    assert(before <= below.objects);
    mark.objects = std::uint32_t(below.objects - before);
    const std::array both{withObjects(below, before), mark};
    marks_.replace(at, marks_.next(at), both);
}

void Containers::eraseMark(const At& at)
{
    const At first = marks_.previous(at);
    const ContainerMark below = marks_[first];
    const auto left = withObjects(below, below.objects + marks_[at].objects);
    marks_.replace(first, marks_.next(at), std::span(&left, 1));
}

// Assigns labels to marks that will follow directly behind `opening` and `closing`, which may be
// the same. Small steps leave labels for further marks at the same place, in most orders of
// insertion.
void Containers::giveLabels(ContainerId id, const At& opening, const At& closing)
{
    constexpr std::uint64_t usual = std::uint64_t(1) << 32;
    const auto gapBehind = [&](const At& at) {
        return labelOf(marks_[marks_.next(at)]) - labelOf(marks_[at]);
    };
    if (gapBehind(opening) < 3 || gapBehind(closing) < 3)
        spreadLabels();
    const auto step = [&](const At& at) { return std::min(gapBehind(at) / 3, usual); };
    const std::uint64_t opens = labelOf(marks_[opening]) + step(opening);
    const std::uint64_t closes =
        (opening == closing ? opens : labelOf(marks_[closing])) + step(closing);
    table_.own(id).opens = opens;
    table_.own(id).closes = closes;
}

} // namespace app

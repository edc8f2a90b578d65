// SPDX-License-Identifier: GPL-3.0-or-later
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

/// What happens to the marks around a place where objects leave and come.
class Splicing {
public:
    explicit Splicing(std::vector<ContainerMark> marks)
        : marks_(std::move(marks)), lost_(marks_.size())
    {
    }

    // `before`: how many objects come before the first of the marks.
    void remove(std::size_t before, std::size_t first, std::size_t count)
    {
        for (std::size_t i = 0; i < marks_.size(); ++i) {
            const std::size_t end = before + marks_[i].objects;
            const std::size_t from = std::max(before, first), to = std::min(end, first + count);
            if (from < to) {
                marks_[i].objects -= std::uint32_t(to - from);
                lost_[i] = true;
            }
            before = end;
        }
    }

    template <class Owner>
    void add(std::size_t count, ContainerId into, const Owner& ownerOf)
    {
        const auto last =
            std::find_if(marks_.rbegin(), marks_.rend(),
                         [&](const ContainerMark& mark) { return ownerOf(mark) == into; });
        assert(last != marks_.rend()); // it neither has nor touches the place
        last->objects += std::uint32_t(count);
    }

    // The marks without groups that have lost their last object; calls gone(id) for these and those
    // in them.
    template <class IsGroup, class Gone>
    std::vector<ContainerMark> withoutEmptied(const IsGroup& isGroup, const Gone& gone) const
    {
        struct Open {
            std::size_t at;            // in `left`
            std::size_t objects, lost; // how many objects, and marks that lost some, came before
        };
        std::vector<ContainerMark> left;
        std::vector<Open> open;
        std::size_t objects = 0, lost = 0;
        for (std::size_t i = 0; i < marks_.size(); ++i) {
            const ContainerMark& mark = marks_[i];
            if (!mark.closes)
                open.push_back({left.size(), objects, lost});
            left.push_back(mark);
            if (mark.closes && !open.empty()) {
                const Open opened = open.back();
                open.pop_back();
                if (isGroup(mark.id) && opened.objects == objects && opened.lost < lost)
                    drop(opened.at, left, gone);
            }
            objects += mark.objects;
            lost += lost_[i];
        }
        return left;
    }

private:
    // The last of `left` closes what the one at `at` opens. Its objects are of the one around it.
    template <class Gone>
    static void drop(std::size_t at, std::vector<ContainerMark>& left, const Gone& gone)
    {
        const std::uint32_t objects = left.back().objects;
        for (std::size_t i = at; i < left.size(); ++i)
            if (!left[i].closes)
                gone(ContainerId(left[i].id));
        left.resize(at);
        left.back().objects += objects;
    }

    std::vector<ContainerMark> marks_;
    std::vector<bool> lost_; ///< objects of each
};

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
    // All marks that touch the place, up to the first that keeps objects above it.
    const At from = first > 0 ? marks_.before(first - 1) : marks_.begin();
    const At to =
        first + removed < objects() ? marks_.next(marks_.before(first + removed)) : marks_.end();
    std::vector<ContainerMark> around;
    for (At at = from; at != to; at = marks_.next(at))
        around.push_back(marks_[at]);
    Splicing splicing(std::move(around));
    splicing.remove(marks_.objectsBefore(from), first, removed);
    if (added > 0)
        splicing.add(added, into, [this](const ContainerMark& mark) { return ownerOf(mark); });

    Containers tree = *this;
    const auto isGroup = [this](ContainerId id) {
        return (*this)[id].kind == Container::Kind::Group;
    };
    const auto left = splicing.withoutEmptied(isGroup, [&](ContainerId id) { tree.forget(id); });
    tree.marks_.replace(from, to, left);
    return tree;
}

std::optional<Containers> Containers::inserted(Container container, ContainerId parent,
                                               std::size_t at, const ObjectRange& range) const
{
    assert(table_.mayHold(parent, container.kind));
    const auto children = childrenOf(parent);
    assert(at <= children.size());
    std::size_t end = at; // of those that it takes over
    int height = 0;       // of the highest of them
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

// A mark among the objects that follow the one at `at`, where `object` of all is the next one.
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

// Labels for marks that will come right behind `opening` and right behind `closing`, which may be
// the same. Small steps leave room for more at the same place, in most orders.
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/containers.h"

#include "app/document/containers_builder.h"

#include <algorithm>
#include <cassert>
#include <utility>

namespace app {

Containers::Containers() : Containers(ContainersBuilder().take()) {}

Containers::Containers(const ContainerMarks& marks, ContainerTable table, std::size_t count)
    : marks_(marks), table_(std::move(table)), count_(count)
{
    spreadLabels();
}

int Containers::depthOf(ContainerId id) const
{
    int depth = 0;
    for (; id != 0; id = parentOf(id))
        ++depth;
    return depth;
}

std::vector<ContainerId> Containers::childrenOf(ContainerId id) const
{
    std::vector<ContainerId> children;
    for (At at = marks_.next(opening(id)); !marks_[at].closes;) {
        const ContainerId child = marks_[at].id;
        children.push_back(child);
        at = marks_.next(at);
        if (marks_[at].id != child) // it has child containers
            at = closing(child);
        at = marks_.next(at);
    }
    return children;
}

std::vector<ContainerId> Containers::inOrder() const
{
    std::vector<ContainerId> all;
    all.reserve(count_);
    for (At at = marks_.next(marks_.begin()); at != marks_.end(); at = marks_.next(at))
        if (const ContainerMark& mark = marks_[at]; !mark.closes)
            all.push_back(mark.id);
    return all;
}

ObjectRange Containers::rangeOf(ContainerId id) const
{
    return {marks_.objectsBefore(opening(id)), marks_.objectsBefore(closing(id))};
}

ContainerId Containers::containerOf(std::size_t object) const
{
    assert(object < objects());
    return ownerOf(marks_[marks_.before(object)]);
}

ContainerId Containers::layerOf(std::size_t object) const
{
    ContainerId id = containerOf(object);
    while ((*this)[id].kind != Container::Kind::Layer)
        id = parentOf(id);
    return id;
}

bool Containers::shown(ContainerId id) const
{
    while (id != 0 && (*this)[id].visible)
        id = parentOf(id);
    return id == 0;
}

bool Containers::locked(ContainerId id) const
{
    while (id != 0 && !(*this)[id].locked)
        id = parentOf(id);
    return id != 0;
}

ObjectRanges Containers::hiddenRanges() const
{
    return rangesWhere([](const Container& container) { return !container.visible; });
}

ObjectRanges Containers::lockedRanges() const
{
    return rangesWhere([](const Container& container) { return container.locked; });
}

template <class Holds>
ObjectRanges Containers::rangesWhere(const Holds& holds) const
{
    ObjectRanges ranges;
    ContainerId outermost = 0;
    std::size_t object = 0, first = 0;
    for (At at = marks_.begin(); at != marks_.end(); at = marks_.next(at)) {
        const ContainerMark& mark = marks_[at];
        if (outermost == 0 && !mark.closes && holds((*this)[mark.id])) {
            outermost = mark.id;
            first = object;
        } else if (outermost != 0 && mark.closes && mark.id == outermost) {
            ranges.insert(ObjectRange{first, object});
            outermost = 0;
        }
        object += mark.objects;
    }
    return ranges;
}

std::vector<ContainerId> Containers::underlaid() const
{
    std::vector<ContainerId> ids;
    if (!isUnderlaid())
        return ids;
    for (ContainerId id = 1; id < nextId(); ++id)
        if (contains(id) && (*this)[id].underlay)
            ids.push_back(id);
    std::ranges::sort(ids, {}, [&](ContainerId id) { return table_[id].opens; });
    return ids;
}

bool operator==(const Containers& a, const Containers& b)
{
    if (a.size() != b.size() || a.objects() != b.objects())
        return false;
    auto other = b.marks_.begin();
    for (auto at = a.marks_.begin(); at != a.marks_.end(); at = a.marks_.next(at)) {
        const ContainerMark& mark = a.marks_[at];
        if (mark != b.marks_[other] || a.table_[mark.id] != b.table_[mark.id])
            return false;
        other = b.marks_.next(other);
    }
    return true;
}

// Labels locate marks: they ascend in painting order after any insertion or removal.

std::uint64_t Containers::labelOf(const ContainerMark& mark) const
{
    return mark.closes ? table_[mark.id].closes : table_[mark.id].opens;
}

Containers::At Containers::labelled(std::uint64_t label) const
{
    return marks_.lastWhere([&](const ContainerMark& mark) { return labelOf(mark) <= label; });
}

ContainerId Containers::ownerOf(const ContainerMark& mark) const
{
    return mark.closes ? parentOf(mark.id) : mark.id;
}

void Containers::spreadLabels()
{
    const std::uint64_t step = ~std::uint64_t(0) / (2 * count_ + 3);
    std::uint64_t label = 0;
    for (At at = marks_.begin(); at != marks_.end(); at = marks_.next(at)) {
        const ContainerMark& mark = marks_[at];
        auto& entry = table_.own(mark.id);
        (mark.closes ? entry.closes : entry.opens) = label += step;
    }
}

} // namespace app

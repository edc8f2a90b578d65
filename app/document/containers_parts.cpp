// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/containers.h"

#include <algorithm>
#include <unordered_set>

namespace app {

Containers::Parts Containers::parts() const
{
    Parts parts;
    for (At at = marks_.begin(); at != marks_.end(); at = marks_.next(at))
        parts.marks.push_back(marks_[at]);
    for (ContainerId id = 1; id < nextId(); ++id)
        if (contains(id))
            parts.containers.push_back((*this)[id]);
    parts.nextId = nextId();
    return parts;
}

namespace {

constexpr ContainerId mostIds = 1 << 26; // a table of ids takes some bytes for each

// Ids ascend below the next one.
bool validIds(const Containers::Parts& parts)
{
    constexpr auto notBelow = [](const Container& a, const Container& b) { return a.id >= b.id; };
    const auto& all = parts.containers;
    return !all.empty() && all.size() <= Containers::mostContainers && all.front().id > 0
           && all.back().id < parts.nextId && parts.nextId <= mostIds
           && std::ranges::adjacent_find(all, notBelow) == all.end();
}

} // namespace

// The marks are brackets: the document's around all others, and one pair for each container.
std::optional<Containers> Containers::of(const Parts& parts)
{
    const auto& marks = parts.marks;
    if (!validIds(parts) || marks.size() != 2 * parts.containers.size() + 2)
        return std::nullopt;
    ContainerTable table;
    for (const Container& container : parts.containers) {
        table.startIdsAt(container.id);
        table.add(container, 0);
    }
    table.startIdsAt(parts.nextId);

    std::vector<ContainerId> open;
    std::unordered_set<ContainerId> seen;
    std::uint64_t objects = 0;
    for (std::size_t i = 0; i < marks.size(); ++i) {
        const ContainerMark& mark = marks[i];
        objects += mark.objects;
        if (mark.closes) {
            const bool last = i + 1 == marks.size();
            if (open.empty() || open.back() != mark.id || (mark.id == 0) != last)
                return std::nullopt;
            open.pop_back();
        } else {
            if ((mark.id == 0) != (i == 0) || !table.contains(mark.id)
                || !seen.insert(mark.id).second || int(open.size()) > deepest)
                return std::nullopt;
            if (i > 0) {
                const Container& container = *table[mark.id].container;
                if (container.underlay && container.kind != Container::Kind::Layer)
                    return std::nullopt;
                if (!table.mayHold(open.back(), container.kind))
                    return std::nullopt;
                table.own(mark.id).parent = open.back();
            }
            open.push_back(mark.id);
        }
        if (mark.objects > 0 && (open.empty() || open.back() == 0))
            return std::nullopt; // only layers lie directly in the document
    }
    if (!open.empty() || objects >= (std::uint64_t(1) << 32))
        return std::nullopt;
    return Containers(ContainerMarks(marks), std::move(table), parts.containers.size());
}

} // namespace app

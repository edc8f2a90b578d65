// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/moved_runs.h"
#include "app/document/tree_draft.h"

#include <algorithm>

// The edit that a draft leads to.

namespace app {

/// The draft from bottom to top.
struct TreeDraft::Layout {
    Containers::Parts parts{};
    std::vector<ContainerId> kept{};
    std::vector<MovedRun> runs{};
};

void TreeDraft::lay(ContainerId id, Layout& layout) const
{
    auto& marks = layout.parts.marks;
    const std::size_t start = marks.size(), runs = layout.runs.size(), kept = layout.kept.size();
    const auto opening = [](ContainerId of) { return ContainerMark{of, 0, 0}; };
    marks.push_back(opening(id));
    if (id != 0)
        layout.kept.push_back(id);
    if (const auto list = lists_.find(id); list != lists_.end())
        for (const TreeItem& item : list->second) {
            if (item.id != 0) {
                lay(item.id, layout);
            } else if (!item.objects.empty()) {
                layout.runs.push_back({item.objects, item.added});
                marks.back().objects += std::uint32_t(item.objects.size());
            }
        }
    const bool wasEmpty = id < firstMade_ && document_.containers().rangeOf(id).empty();
    if (id != 0 && (*this)[id].kind == Container::Kind::Group && layout.runs.size() == runs
        && !wasEmpty) {
        marks.resize(start);
        layout.kept.resize(kept);
        return;
    }
    ContainerMark closing = opening(id);
    closing.closes = 1;
    marks.push_back(closing);
}

std::optional<Containers> TreeDraft::treeOf(Layout layout) const
{
    std::ranges::sort(layout.kept);
    for (const ContainerId id : layout.kept) {
        layout.parts.containers.push_back((*this)[id]);
        layout.parts.containers.back().id = id;
    }
    layout.parts.nextId = firstMade_ + ContainerId(made_.size());
    return Containers::of(layout.parts);
}

std::optional<Rearranged> TreeDraft::rearranged() const
{
    Layout layout;
    lay(0, layout);
    Rearranged result;
    MovedObjects moved = objectsMoved(document_.objects(), added_, layout.runs, chosen_);
    result.edit.splices = std::move(moved.splices);
    result.edit.objects = std::move(moved.objects);
    result.edit.moved = std::move(moved.moved);
    result.chosen = std::move(moved.chosen);
    result.added = std::move(moved.added);
    if (!made_.empty() || layout.parts.marks != document_.containers().parts().marks) {
        auto tree = treeOf(std::move(layout));
        if (!tree)
            return std::nullopt;
        result.edit.containers = std::move(tree);
    }
    return result;
}

} // namespace app

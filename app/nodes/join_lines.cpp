// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/nodes/join_lines.h"

#include "app/nodes/end_joining.h"

#include <algorithm>
#include <map>
#include <utility>

namespace app {
namespace {

/// The open paths of a drawing as nodes.
struct OpenPaths {
    NodePath path{};
    std::vector<std::size_t> owners{}; ///< the object of each
    std::vector<std::uint32_t> pens{}; ///< a number for each container and style
};

OpenPaths openPathsOf(const Document& document)
{
    OpenPaths open;
    std::map<std::tuple<ContainerId, StyleIndex, KeptClips>, std::uint32_t> pens;
    const Objects& objects = document.objects();
    objects.forEach(0, objects.size(), [&](std::size_t i, const ObjectView& object) {
        if (!std::holds_alternative<std::monostate>(object.particulars().recipe))
            return;
        const std::vector<Subpath> subpaths = object.path().subpaths();
        if (subpaths.size() != 1 || subpaths[0].closed || subpaths[0].segments.empty())
            return;
        open.path.push_back(nodesOf(subpaths).front());
        open.owners.push_back(i);
        const auto pen = std::tuple(document.containers().containerOf(i), object.styleIndex(),
                                    object.particulars().clips);
        open.pens.push_back(pens.emplace(pen, std::uint32_t(pens.size())).first->second);
    });
    return open;
}

} // namespace

std::size_t joinLines(Document& document, double tolerance)
{
    OpenPaths open = openPathsOf(document);
    const NodePath before = open.path;
    const std::vector<std::size_t> all = open.owners;
    const std::size_t joints = joinEnds(open.path, open.owners, tolerance, open.pens);
    if (joints == 0)
        return 0;
    Edit edit;
    edit.objects = document.objects().slice(0, 0);
    for (std::size_t i = 0, left = 0; i < all.size(); ++i) {
        const bool stays = left < open.owners.size() && open.owners[left] == all[i];
        if (stays && open.path[left] == before[i]) {
            ++left;
            continue;
        }
        edit.splices.push_back({std::uint32_t(all[i]), 1, stays ? 1U : 0U});
        if (stays) {
            ObjectRow row = document.objects()[all[i]].row();
            row.path = Path(subpathsOf(std::span(open.path).subspan(left++, 1)));
            edit.objects.append(row);
        }
    }
    edit.containers = document.containers().spliced(edit.splices);
    document.apply(edit);
    return joints;
}

} // namespace app

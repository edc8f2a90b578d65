// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/kept_rows.h"

#include <algorithm>
#include <optional>

namespace app {
namespace {

/// The numbers of objects after splices.
class Renumbering {
public:
    explicit Renumbering(std::span<const Splice> splices) : splices_(splices)
    {
        before_.reserve(splices.size() + 1);
        before_.push_back(0);
        for (const Splice& splice : splices)
            before_.push_back(before_.back() + std::ptrdiff_t(splice.added)
                              - std::ptrdiff_t(splice.removed));
    }
    std::optional<std::size_t> operator()(std::size_t object) const
    {
        const auto above = std::ranges::partition_point(
            splices_, [&](const Splice& splice) { return splice.first <= object; });
        const std::size_t passed = std::size_t(above - splices_.begin());
        if (passed > 0) {
            const Splice& last = splices_[passed - 1];
            if (object < std::size_t(last.first) + last.removed)
                return last.removed == last.added ? std::optional(shifted(object, passed - 1))
                                                  : std::nullopt;
        }
        return shifted(object, passed);
    }

private:
    std::size_t shifted(std::size_t object, std::size_t passed) const
    {
        return std::size_t(std::ptrdiff_t(object) + before_[passed]);
    }

    std::span<const Splice> splices_;
    std::vector<std::ptrdiff_t> before_; ///< by how much the first ones shift what lies above
};

} // namespace

KeptRows keptRows(const std::vector<TreeRow>& rows, std::span<const Splice> splices,
                  const Containers& containers)
{
    const Renumbering renumbered(splices);
    KeptRows kept;
    for (std::size_t i = 0; i < rows.size(); ++i) {
        TreeRow row = rows[i];
        bool stays = true;
        if (row.kind == TreeRow::Kind::Object) {
            const auto now = renumbered(row.number);
            stays = now && *now < containers.objects();
            if (stays)
                row = {row.kind, containers.containerOf(*now), *now, row.depth};
        } else {
            stays = containers.contains(row.container);
        }
        if (stays)
            kept.rows.push_back(row);
        else
            kept.lost.push_back(i);
    }
    return kept;
}

} // namespace app

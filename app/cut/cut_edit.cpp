// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cut/cut_edit.h"

namespace app {

CutEdit::CutEdit(const Document& document, Grouping grouping)
    : document_(document), grouping_(grouping), hidden_(document.containers().hiddenRanges()),
      locked_(document.containers().lockedRanges())
{
    cut_.edit.objects = document.objects().slice(0, 0);
}

bool CutEdit::isHidden(std::size_t object) const
{
    return document_.objects()[object].hidden() || hidden_.contains(object);
}

void CutEdit::keep(std::size_t object)
{
    ++cut_.counts.whole;
    cut_.counts.hidden += isHidden(object);
}

void CutEdit::remove(std::size_t object)
{
    ++cut_.counts.gone;
    cut_.counts.cutLocked += isLocked(object);
    --more_;
    auto& splices = cut_.edit.splices;
    if (!splices.empty() && splices.back().added == 0
        && splices.back().first + splices.back().removed == object)
        ++splices.back().removed;
    else
        splices.push_back({std::uint32_t(object), 1, 0});
}

void CutEdit::cut(std::size_t object, CutObject result)
{
    ++cut_.counts.cut;
    cut_.counts.hidden += isHidden(object);
    cut_.counts.cutLocked += isLocked(object);
    cut_.counts.opened += result.opened;
    cut_.counts.slanted += result.slanted;
    const bool grouped = result.parted && grouping_ == Grouping::Yes;
    if (grouped)
        addGroup(object, result.left.size());
    cut_.edit.splices.push_back({std::uint32_t(object), 1, std::uint32_t(result.left.size())});
    more_ += std::ptrdiff_t(result.left.size()) - 1;
    for (std::size_t i = 0; i < result.left.size(); ++i) {
        Object& left = result.left[i];
        if (grouped)
            left.particulars = {};
        else if (i > 0)
            left.particulars.id = ids_.next(document_.objects()[object].particulars().id);
        cut_.edit.objects.append(left);
    }
}

void CutEdit::addGroup(std::size_t object, std::size_t parts)
{
    const Particulars& particulars = document_.objects()[object].particulars();
    const auto first = std::size_t(std::ptrdiff_t(object) + more_);
    groups_.push_back({{first, first + parts},
                       {.kind = Container::Kind::Group,
                        .svgId = particulars.id,
                        .title = particulars.title,
                        .description = particulars.description}});
}

void CutEdit::change(std::size_t object, const Object& changed)
{
    keep(object);
    cut_.edit.splices.push_back({std::uint32_t(object), 1, 1});
    cut_.edit.objects.append(changed);
}

std::optional<Cut> CutEdit::take()
{
    if (!cut_.edit.splices.empty()) {
        auto tree = withGroups(document_.containers().spliced(cut_.edit.splices), groups_);
        if (!tree)
            return std::nullopt;
        cut_.edit.containers = std::move(tree);
    }
    return std::move(cut_);
}

} // namespace app

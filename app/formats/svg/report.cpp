// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/svg/report.h"

#include "app/formats/svg/refused.h"

#include <algorithm>

namespace app::svg {

void Report::add(const LossKind& kind, int count)
{
    if (count == 0)
        return;
    const auto found = std::ranges::find(counted_, &kind, &Counted::kind);
    if (found != counted_.end())
        found->count += count;
    else
        counted_.push_back({&kind, count});
}

std::vector<Loss> Report::losses() const
{
    std::vector<Loss> losses;
    for (const auto& [kind, count] : counted_) {
        const char* const instead = count == 1 ? kind->oneInstead : kind->manyInstead;
        losses.push_back({Text::tr(count == 1 ? kind->one : kind->many), count, kind->remark,
                          instead ? Text::tr(instead) : QString()});
    }
    return losses;
}

} // namespace app::svg

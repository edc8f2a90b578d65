// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/shared.h"

#include <algorithm>
#include <functional>
#include <vector>

namespace app {

/// Calls visit(i) for each index i of `mine` whose value `theirs` does not share. Elements that
/// both lists share at the beginning and at the end cost little.
template <class T, class Visit>
void forEachNotIn(const std::vector<Shared<T>>& theirs, const std::vector<Shared<T>>& mine,
                  const Visit& visit)
{
    const auto same = [](const Shared<T>& a, const Shared<T>& b) { return sameAddress(a, b); };
    const auto [from, theirFrom] =
        std::mismatch(mine.begin(), mine.end(), theirs.begin(), theirs.end(), same);
    const auto [end, theirEnd] =
        std::mismatch(mine.rbegin(), std::reverse_iterator(from), theirs.rbegin(),
                      std::reverse_iterator(theirFrom), same);
    std::vector<const T*> others;
    for (auto other = theirFrom; other != theirEnd.base(); ++other)
        others.push_back(&**other);
    std::ranges::sort(others, std::less<>());
    for (auto each = from; each != end.base(); ++each)
        if (!std::ranges::binary_search(others, &**each, std::less<>()))
            visit(std::size_t(each - mine.begin()));
}

} // namespace app

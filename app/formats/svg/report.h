// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

#include <algorithm>

namespace app::svg {

/// Counts what an import meets and cannot keep, or keeps in another way.
class Report {
public:
    void lost(const QString& what, int count = 1) { add(what, count, false); }
    void remark(const QString& what, int count = 1) { add(what, count, true); }
    std::vector<Loss> take() { return std::move(losses_); }

private:
    void add(const QString& what, int count, bool remark)
    {
        const auto found = std::ranges::find(losses_, what, &Loss::what);
        if (found != losses_.end())
            found->count += count;
        else if (count > 0)
            losses_.push_back({what, count, remark});
    }
    std::vector<Loss> losses_;
};

} // namespace app::svg

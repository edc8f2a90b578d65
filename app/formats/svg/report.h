// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"
#include "app/formats/svg/losses.h"

namespace app::svg {

/// Counts what an import meets and cannot keep, or keeps in another way.
class Report {
public:
    void add(const LossKind& kind, int count = 1);
    std::vector<Loss> losses() const; ///< in the order in which they were met

private:
    struct Counted {
        const LossKind* kind;
        int count;
    };
    std::vector<Counted> counted_;
};

} // namespace app::svg

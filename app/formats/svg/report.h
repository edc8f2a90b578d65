// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"
#include "app/formats/svg/losses.h"

#include <string_view>

namespace app::svg {

/// Counts what an import meets and cannot keep, or keeps in another way.
class Report {
public:
    void add(const LossKind& kind, int count = 1);
    /// One of a kind that names the text that was met.
    void add(const LossKind& kind, std::string_view text);
    std::vector<Loss> losses() const; ///< in the order in which they were met

private:
    struct Counted {
        const LossKind* kind;
        int count;
        QStringList texts{}; ///< the first different ones, as they are shown
    };
    Counted& of(const LossKind& kind);

    std::vector<Counted> counted_;
};

} // namespace app::svg

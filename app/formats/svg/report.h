// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"
#include "app/formats/svg/losses.h"

#include <string_view>

namespace app::svg {

/// Counts the content of a file that an import cannot keep, or keeps in another form.
class Report {
public:
    void add(const LossKind& kind, int count = 1);
    /// Adds one loss of a kind whose sentence quotes `text`.
    void add(const LossKind& kind, std::string_view text);
    std::vector<Loss> losses() const; ///< in the order of first occurrence

private:
    struct Counted {
        const LossKind* kind;
        int count;
        QStringList texts{}; ///< the first different texts, shortened for display
    };
    Counted& of(const LossKind& kind);

    std::vector<Counted> counted_;
};

} // namespace app::svg

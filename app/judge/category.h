// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/judge/judgement.h"

#include <vector>

namespace app::plug_in {

/// Which lines of a category.
struct Scope {
    std::uint64_t seed = 1;
    Strictness strictness = Strictness::Textbook; ///< further ones for the stricter contract
    std::size_t randomLines = 100'000;            ///< of the paper's scene
};

/// When the lines of a category are clipped. Again: a second time, in another order, when all
/// others are done; the answer must be the first one, bit for bit. InTheRace: while it is timed.
enum class Asked : std::uint8_t { Once, Again, InTheRace };

/// One row of the catalogue of what a library is asked.
struct Category {
    QString key;           ///< in files: "corners"
    QString name;          ///< "Corners", translated, as is what follows
    QString meaning;       ///< one sentence
    double visibilityUlps; ///< how far edges may move for a wrong visibility; 0: not at all
    std::vector<Question> (*questions)(const Scope& scope); ///< depend on the scope alone
    Asked asked = Asked::Once;
};

/// In the order in which they are asked: the simple ones first, then many random lines, then some
/// of all these again, at last the race.
std::span<const Category> categories();

} // namespace app::plug_in

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/judge/judgement.h"

#include <vector>

namespace app::plug_in {

/// The lines that a category asks about.
struct Scope {
    std::uint64_t seed = 1;
    Strictness strictness = Strictness::Textbook; ///< the strict contract adds further lines
    std::size_t randomLines = 100'000;            ///< from the paper's scene
};

/// When the lines of a category are clipped. Again: a second time in another order, after all other
/// categories; the answer must equal the first one bit for bit. InTheRace: while the library is
/// timed.
enum class Asked : std::uint8_t { Once, Again, InTheRace };

/// One row of the catalogue of tests of a library.
struct Category {
    QString key;           ///< in files: "corners"
    QString name;          ///< "Corners", translated, like the next text
    QString meaning;       ///< one sentence
    double visibilityUlps; ///< how far edges may move to excuse a wrong visibility; 0: never
    std::vector<Question> (*questions)(const Scope& scope); ///< depend only on the scope
    Asked asked = Asked::Once;
};

/// In the order of the tests: first simple lines, then many random lines, then some of all these
/// again, finally the race.
std::span<const Category> categories();

} // namespace app::plug_in

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/plug_in/judgement.h"

#include <vector>

namespace app::plug_in {

/// Which lines of a category.
struct Scope {
    std::uint64_t seed = 1;
    Strictness strictness = Strictness::Textbook; ///< further ones for the stricter contract
    std::size_t randomLines = 100'000;            ///< of the paper's scene
};

/// One row of the catalogue of what a library is asked.
struct Category {
    QString key;           ///< in files: "corners"
    QString name;          ///< "Corners", translated, as is what follows
    QString meaning;       ///< one sentence
    double visibilityUlps; ///< how far edges may move for a wrong visibility; 0: not at all
    std::vector<Question> (*questions)(const Scope& scope); ///< depend on the scope alone
};

/// In the order in which they are asked: the simple ones first, many random lines last.
std::span<const Category> categories();

} // namespace app::plug_in

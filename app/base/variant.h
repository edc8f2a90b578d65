// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

namespace app {

struct Misprint;

/// What clips or competes: one form of an algorithm, or a known misprint.
struct Variant {
    const clipping::Algorithm* algorithm = nullptr;  ///< for a misprint: the algorithm meant
    clipping::Form form = clipping::Form::Corrected; ///< for a misprint: Published
    const Misprint* misprint = nullptr;              ///< null: not a misprint

    friend bool operator==(const Variant&, const Variant&) = default;
};

/// The wish, in the corrected form if its algorithm has no published form that can clip.
inline Variant usable(const Variant& wish)
{
    const bool has = clipping::functionsOf(*wish.algorithm, wish.form);
    return {wish.algorithm, has ? wish.form : clipping::Form::Corrected};
}

/// The default algorithm: the one whose results are always exact.
inline const clipping::Algorithm& usualAlgorithm() { return clipping::exactAlgorithm(); }

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

namespace app {

struct Exhibit;

/// What clips, or competes: one form of an algorithm, which it has, or an exhibit.
struct Variant {
    const clipping::Algorithm* algorithm = nullptr;  ///< of an exhibit: what it was meant to be
    clipping::Form form = clipping::Form::Corrected; ///< of an exhibit: published
    const Exhibit* exhibit = nullptr;                ///< nothing: the form of the algorithm

    friend bool operator==(const Variant&, const Variant&) = default;
};

/// The form of the wish's algorithm that can clip: corrected where that has no published one.
inline Variant usable(const Variant& wish)
{
    const bool has = clipping::usesOf(*wish.algorithm, wish.form);
    return {wish.algorithm, has ? wish.form : clipping::Form::Corrected};
}

} // namespace app

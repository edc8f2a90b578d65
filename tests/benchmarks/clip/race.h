// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

#include "tests/benchmarks/clip/agreement.h"
#include "tests/benchmarks/timing.h"

/// What came out where everybody clipped one scene, in turns.
struct Race {
    std::string scene, numbers;
    std::size_t count = 0;
    std::size_t visible = 0;   ///< by `exact`
    std::size_t unsettled = 0; ///< left to the scalar algorithm by the fastest vectors
    std::vector<Contender> contenders{};
    std::vector<NamedAgreement> agreements{};

    const Contender* find(std::string_view name) const
    {
        const auto found = std::ranges::find(contenders, name, &Contender::name);
        return found == contenders.end() ? nullptr : &*found;
    }
};

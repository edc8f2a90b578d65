// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "clipping/algorithm.h"

#include <QString>

#include <span>
#include <vector>

namespace app {

/// One form of one algorithm, which it has.
struct Contestant {
    const clipping::Algorithm* algorithm;
    clipping::Form form;
    friend bool operator==(const Contestant&, const Contestant&) = default;
};

/// Every form that these algorithms have, the corrected ones first.
std::vector<Contestant> contestants(std::span<const clipping::Algorithm* const> algorithms);

/// Every one of them in one form, without those that do not have it.
std::vector<Contestant> contestants(std::span<const clipping::Algorithm* const> algorithms,
                                    clipping::Form form);

/// "corrected", "published".
QString wordOf(clipping::Form form);

} // namespace app

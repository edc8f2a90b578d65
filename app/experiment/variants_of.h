// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"

#include <QString>

#include <span>
#include <vector>

namespace app {

/// Every form that these algorithms have, the corrected ones first.
std::vector<Variant> variantsOf(std::span<const clipping::Algorithm* const> algorithms);

/// Every one of them in one form, without those that do not have it.
std::vector<Variant> variantsOf(std::span<const clipping::Algorithm* const> algorithms,
                                clipping::Form form);

/// "corrected", "published".
QString wordOf(clipping::Form form);

} // namespace app

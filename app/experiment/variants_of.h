// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/variant.h"

#include <QString>

#include <span>
#include <vector>

namespace app {

/// Every form of these algorithms, the corrected forms first.
std::vector<Variant> variantsOf(std::span<const clipping::Algorithm* const> algorithms);

/// The algorithms that have this form, in this form.
std::vector<Variant> variantsOf(std::span<const clipping::Algorithm* const> algorithms,
                                clipping::Form form);

/// "corrected", "published".
QString wordOf(clipping::Form form);

} // namespace app

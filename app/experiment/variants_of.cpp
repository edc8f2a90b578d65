// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/variants_of.h"

namespace app {

std::vector<Variant> variantsOf(std::span<const clipping::Algorithm* const> algorithms,
                                clipping::Form form)
{
    std::vector<Variant> all;
    for (const auto* algorithm : algorithms)
        if (clipping::functionsOf(*algorithm, form))
            all.push_back({algorithm, form});
    return all;
}

std::vector<Variant> variantsOf(std::span<const clipping::Algorithm* const> algorithms)
{
    auto all = variantsOf(algorithms, clipping::Form::Corrected);
    const auto published = variantsOf(algorithms, clipping::Form::Published);
    all.insert(all.end(), published.begin(), published.end());
    return all;
}

QString wordOf(clipping::Form form)
{
    return form == clipping::Form::Corrected ? QStringLiteral("corrected")
                                             : QStringLiteral("published");
}

} // namespace app

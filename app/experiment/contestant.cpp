// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/contestant.h"

namespace app {

std::vector<Contestant> contestants(std::span<const clipping::Algorithm* const> algorithms,
                                    clipping::Form form)
{
    std::vector<Contestant> all;
    for (const auto* algorithm : algorithms)
        if (clipping::usesOf(*algorithm, form))
            all.push_back({algorithm, form});
    return all;
}

std::vector<Contestant> contestants(std::span<const clipping::Algorithm* const> algorithms)
{
    auto all = contestants(algorithms, clipping::Form::Corrected);
    const auto published = contestants(algorithms, clipping::Form::Published);
    all.insert(all.end(), published.begin(), published.end());
    return all;
}

QString wordOf(clipping::Form form)
{
    return form == clipping::Form::Corrected ? QStringLiteral("corrected")
                                             : QStringLiteral("published");
}

} // namespace app

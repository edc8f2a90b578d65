// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/analysis.h"

#include "app/base/text.h"
#include "app/experiment/accuracy.h"
#include "app/experiment/class_profile.h"
#include "app/experiment/one_by_one.h"
#include "app/experiment/operation_profile.h"

namespace app {
namespace {

using Variants = std::span<const Variant>;

std::optional<Table> classes(const ExperimentOptions& options, Variants variants,
                             const Follower& follower)
{
    const auto profile = classProfile(options, variants, follower);
    return profile ? std::optional(classTable(*profile)) : std::nullopt;
}

std::optional<Table> operations(const ExperimentOptions& options, Variants variants,
                                const Follower& follower)
{
    const auto profile = operationProfile(options, withoutOneByOne(variants), follower);
    return profile ? std::optional(operationTable(*profile)) : std::nullopt;
}

std::optional<Table> accuracy(const ExperimentOptions& options, Variants variants,
                              const Follower& follower)
{
    const auto all = accuracies(options, withoutOneByOne(variants), follower);
    return all ? std::optional(accuracyTable(*all, options)) : std::nullopt;
}

} // namespace

std::vector<Analysis> analyses()
{
    return {
        {"classes", Text::tr("Times by class"),
         Text::tr("The cost of lines that are inside, rejected at once, cut, or miss the window."),
         classes},
        {"operations", Text::tr("Operations"),
         Text::tr("Comparisons, additions, multiplications and divisions per line."), operations},
        {"accuracy", Text::tr("Accuracy"),
         Text::tr("Lost lines, ends outside the window, and errors of the ends."), accuracy},
    };
}

} // namespace app

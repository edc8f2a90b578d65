// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/value_unit.h"

#include "app/teaching/teaching.h"

#include <algorithm>
#include <array>

namespace app {

namespace {

/// The usual units: of names that several algorithms use with the same meaning.
constexpr auto usualUnits = [] {
    using enum ValueUnit;
    return std::to_array<VariableUnit>({
        {"t", Bare},
        {"dx", Length},
        {"dy", Length},
        {"rise", Length},
        {"run", Length},
        {"x", X},
        {"y", Y},
        {"xi", X},
        {"yi", Y},
        {"xo", X},
        {"yo", Y},
    });
}();

} // namespace

std::optional<ValueUnit> unitOfValue(const Variant& variant, std::string_view name)
{
    const Teaching row = teachingOf(*variant.algorithm);
    const bool isPublished = variant.form == clipping::Form::Published;
    for (const std::span<const VariableUnit> all :
         {isPublished ? row.published : std::span<const VariableUnit>(), row.variables,
          std::span<const VariableUnit>(usualUnits)})
        if (const auto found = std::ranges::find(all, name, &VariableUnit::name);
            found != all.end())
            return found->unit;
    return std::nullopt;
}

} // namespace app

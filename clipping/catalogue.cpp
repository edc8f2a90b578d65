// SPDX-License-Identifier: MIT
#include "clipping/algorithm.h"
#include "clipping/ieee_numbers.h"

#include <algorithm>
#include <array>

namespace clipping {
namespace {
template <class...>
struct List {
};
} // namespace

// THE CATALOGUE. To add an algorithm: write its file in algorithms/ and add its name here.
// clang-format off
using Catalogue = List<
    struct CohenSutherland,
    struct LiangBarsky,
    struct CyrusBeck,
    struct NichollLeeNicholl,
    struct Skala,
    struct KodituwakkuWijeweeraChamikara,
    struct MatthesDrakopoulos,
    struct MidpointSubdivision,
    struct SobkowPospisilYang,
    struct SlaterBarsky,
    struct WindingNumber,
    struct Exact
>;
// clang-format on

template <class Method>
Algorithm describe(); // instantiated at the end of the file of each Method

template <class... Methods>
static std::array<Algorithm, sizeof...(Methods)> describeAll(List<Methods...>)
{
    return {describe<Methods>()...};
}

std::span<const Algorithm> algorithms() noexcept
{
    static const auto all = describeAll(Catalogue{});
    return all;
}

const Algorithm& exactAlgorithm() noexcept
{
    static const Algorithm& exact = *findAlgorithm("exact");
    return exact;
}

const Algorithm* findAlgorithm(std::string_view wanted) noexcept
{
    const auto lower = [](char c) { return c >= 'A' && c <= 'Z' ? char(c - 'A' + 'a') : c; };
    const auto same = [&](std::string_view name) {
        return std::ranges::equal(name, wanted, {}, lower, lower);
    };
    const auto all = algorithms();
    const auto found = std::ranges::find_if(
        all, [&](const Algorithm& a) { return same(a.key) || same(a.abbreviation); });
    return found == all.end() ? nullptr : &*found;
}

} // namespace clipping

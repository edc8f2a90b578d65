// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/experiment/one_by_one.h"

#include "app/base/text.h"
#include "app/experiment/paper_runs.h"

#include <algorithm>

namespace app {
namespace {

template <class T>
std::size_t clipEach(std::span<const clipping::BasicSegment<T>> in,
                     const clipping::BasicWindow<T>& window,
                     std::span<clipping::BasicClipped<clipping::BasicSegment<T>>> out)
{
    const auto clip = [] {
        if constexpr (std::is_same_v<T, float>)
            return clipping::exactAlgorithm().floats->clip;
        else
            return clipping::exactAlgorithm().corrected.clip;
    }();
    std::size_t visible = 0;
    for (std::size_t i = 0; i < in.size(); ++i)
        if (const auto piece = clip(in[i], window))
            out[visible++] = {*piece, std::uint32_t(i), 0};
    return visible;
}

bool isExact(const Variant& one) { return one.algorithm == &clipping::exactAlgorithm(); }
bool isOneByOne(const Variant& one) { return one.algorithm == &exactOneByOne(); }

} // namespace

const clipping::Algorithm& exactOneByOne()
{
    static const auto single = [] {
        auto uses = *clipping::exactAlgorithm().floats;
        uses.clipAll = clipEach<float>;
        return uses;
    }();
    static const auto row = [] {
        clipping::Algorithm all = clipping::exactAlgorithm();
        all.key = "exact-one-by-one";
        all.abbreviation = "EX one by one";
        all.name = "Exact, one by one";
        all.corrected.clipAll = clipEach<double>;
        all.floats = &single;
        return all;
    }();
    return row;
}

const clipping::Algorithm* timedAlgorithm(const QString& name)
{
    return name == latin(exactOneByOne().key) ? &exactOneByOne() : paperAlgorithm(name);
}

std::vector<Variant> withOneByOne(std::span<const Variant> variants)
{
    std::vector<Variant> all;
    for (const Variant& one : variants) {
        all.push_back(one);
        if (isExact(one))
            all.push_back({&exactOneByOne(), one.form});
    }
    return all;
}

std::vector<Variant> withoutOneByOne(std::span<const Variant> variants)
{
    std::vector<Variant> all(variants.begin(), variants.end());
    std::erase_if(all, isOneByOne);
    return all;
}

QString batchText(std::span<const Variant> variants)
{
    if (std::ranges::none_of(variants, isExact))
        return {};
    const QString batches = Text::tr(
        "Exact (EX) is timed in batches: it clips many lines at once with the processor's vector "
        "instructions. The other algorithms clip one line after another.");
    return std::ranges::none_of(variants, isOneByOne)
               ? batches
               : batches
                     + Text::tr(" “EX one by one” is the same algorithm, called line "
                                "by line.");
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
// Every row that clips infinite lines and rays, against whole numbers.
#include "tests/clipping/line_or_ray_contract.h"
#include "tests/fuzz/one_input.h"

using namespace clipping;

namespace {

template <class S>
void keepContract(const Functions<S, Window, Segment>& uses, const Input& input, double ulps,
                  const std::string& who)
{
    agree<2>(uses, S{input.segment.a, input.segment.b}, input, who);
    const auto result = uses.clip({input.segment.a, input.segment.b}, input.window);
    if (!legalInput<2>(input)) {
        if (result)
            found(who + ": seen where the contract says nothing for " + exactly(input));
        return;
    }
    const auto wrong = lineOrRayFault(result, input, std::is_same_v<S, Ray>, ulps);
    if (!wrong.empty())
        found(who + ": " + wrong + " for " + exactly(input));
}

} // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto input = inputOf<2>({data, size});
    for (const Algorithm& a : algorithms()) {
        if (a.line)
            keepContract(*a.line, input, a.ulps, std::string(a.key) + " of a line");
        if (a.ray)
            keepContract(*a.ray, input, a.ulps, std::string(a.key) + " of a ray");
    }
    return 0;
}

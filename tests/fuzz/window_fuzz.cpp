// SPDX-License-Identifier: GPL-3.0-or-later
// Every row of the catalogue against the oracle; the published forms must come back, no more.
#include "tests/fuzz/one_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto input = inputOf<2>({data, size});
    const auto truth = legalInput<2>(input) ? truthOf<2>(input) : std::nullopt;
    for (const clipping::Algorithm& a : clipping::algorithms()) {
        keepContract<2>(a.corrected, input, truth, a.ulps, std::string(a.key));
        if (a.published)
            a.published->clip(input.segment, input.window);
    }
    return 0;
}

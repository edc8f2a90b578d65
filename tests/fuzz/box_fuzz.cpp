// SPDX-License-Identifier: GPL-3.0-or-later
// Every row that clips in three dimensions, against the oracle.
#include "tests/fuzz/one_input.h"

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const auto input = inputOf<3>({data, size});
    const auto truth = legalInput<3>(input) ? truthOf<3>(input) : std::nullopt;
    for (const clipping::Algorithm& a : clipping::algorithms())
        if (a.box)
            keepContract<3>(*a.box, input, truth, clipping::boxUlps,
                            std::string(a.key) + " in a box");
    return 0;
}

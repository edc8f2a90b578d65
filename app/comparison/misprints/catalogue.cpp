// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/misprints/misprint.h"

namespace app {

// Each is defined in a file of its own.
Misprint printedStep2();
Misprint printedStep2InPlace();

// THE CATALOGUE. To add a known misprint: write its file here, and name it in both lists.
const std::vector<Misprint>& misprints()
{
    // clang-format off
    static const std::vector<Misprint> all{
        printedStep2(),
        printedStep2InPlace(),
    };
    // clang-format on
    return all;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/exhibits/exhibit.h"

namespace app {

// Each is defined in a file of its own.
Exhibit printedStep2();
Exhibit printedStep2InPlace();

// THE CATALOGUE. To add a known misprint: write its file here, and name it in both lists.
const std::vector<Exhibit>& exhibits()
{
    static const std::vector<Exhibit> all{printedStep2(), printedStep2InPlace()};
    return all;
}

} // namespace app

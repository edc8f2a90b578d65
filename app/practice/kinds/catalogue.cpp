// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/practice/kinds/kinds.h"

#include <array>

namespace app {

// Each is defined in the file of its kind.
extern const MoveMaker bitsMaker;
extern const MoveMaker edgeMaker;
extern const MoveMaker placeMaker;
extern const MoveMaker lineMaker;
extern const MoveMaker valueMaker;
extern const MoveMaker decisionMaker;

// THE CATALOGUE, in the order of MoveKind.
const MoveMaker& makerOf(MoveKind kind)
{
    const std::array all{&bitsMaker, &edgeMaker,  &placeMaker,
                         &lineMaker, &valueMaker, &decisionMaker};
    return *all[std::size_t(kind)];
}

} // namespace app

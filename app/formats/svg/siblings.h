// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/svg/tree.h"

namespace app::svg {

/// Where elements stand among their siblings, pieces of text apart. It is found out for all
/// elements at once, when it is asked for.
class Siblings {
public:
    explicit Siblings(const Tree& tree) : tree_(tree) {}

    struct Position {
        std::uint32_t number = 1, count = 1;             ///< from 1
        std::uint32_t numberOfType = 1, countOfType = 1; ///< among those of the same name
        Node previous = noNode;
    };
    const Position& of(Node node);

private:
    void findOut();

    const Tree& tree_;
    std::vector<Position> positions_;
};

} // namespace app::svg

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object.h"

#include <vector>

namespace app::svg {

/// An object while its outline is still being processed, before it is packed.
struct Drawn {
    std::vector<Subpath> paths;
    Style style;
    Particulars particulars{};
    bool hidden = false;
};

} // namespace app::svg

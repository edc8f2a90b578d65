// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "resources/plug_in/clearcut_algorithm.h"

namespace app::plug_in {

using Clip = decltype(&clearcut_clip);

/// A library loaded into this process, which must be a child (child.h).
struct Library {
    Clip clip = nullptr;
    std::string name;  ///< reported by the library; may be empty
    std::string error; ///< if loading failed: a word of `hello` (child.h) and a sentence
};

/// Runs the library's initialization code.
Library loaded(const char* path);

} // namespace app::plug_in

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "resources/plug_in/clearcut_algorithm.h"

namespace app::plug_in {

using Clip = decltype(&clearcut_clip);

/// A library that was loaded into this process, which must be a child (child.h).
struct Library {
    Clip clip = nullptr;
    std::string name;  ///< as it calls itself; may be empty
    std::string error; ///< what goes before it otherwise: a word of `hello` and a sentence
};

/// Runs what the library does when it is loaded.
Library loaded(const char* path);

} // namespace app::plug_in

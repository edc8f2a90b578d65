// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>

namespace clipping::python {

/// Memory of at least `bytes`, of which only the pages that are written are ever occupied. Throws
/// std::bad_alloc. Safe on any thread.
void* takeMemory(std::size_t bytes);

/// Gives it back. The last large one is kept for the next call, because getting new pages from the
/// system takes as long as clipping. The system may take these pages back whenever it needs memory.
void giveMemory(void* memory);

} // namespace clipping::python

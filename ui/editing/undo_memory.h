// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

namespace ui {

/// The memory in MB (10^6 bytes) that the steps to undo may use: a setting, 1,000 unless changed.
int undoMegabytes();
void setUndoMegabytes(int megabytes);

constexpr std::size_t bytesOf(int megabytes) { return std::size_t(megabytes) * 1'000'000; }

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/edge_words.h"

#include <QString>

namespace app {

/// An outcode as it is written everywhere, one digit for each bit of outcodeBits(): "1001". The
/// bits compare coordinates, so an outcode is the same in a drawing, where y grows downward, and in
/// a figure, where y grows upward. Words such as "above" say what is seen on screen.
QString outcodeText(unsigned code);

/// The region of an outcode, as seen on screen: "inside", "left", "above right".
QString regionText(unsigned code, YAxis y);

/// The meaning of the four bits, in their order; the pages define the bits with the same words.
QString outcodeBits();

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace app {

/// An outcode as it is written everywhere, one digit for each question of outcodeBits(): "1001".
/// The bits compare coordinates. So an outcode is the same in a drawing, where y grows downward, as
/// in a figure, where it grows upward. Words such as "above" say what is seen.
QString outcodeText(unsigned code);

/// The meaning of the four bits, in their order; the pages define them with the same words.
QString outcodeBits();

} // namespace app

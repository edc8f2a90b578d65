// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/result.h"

#include <QByteArray>

class QIODevice;

namespace app {

/// All bytes of a pipe, at most `most`: a pipe may never end, and a single token may be as long as
/// the whole input. The error follows the file's name.
Result<QByteArray> wholePipe(QIODevice& in, std::size_t most);

} // namespace app

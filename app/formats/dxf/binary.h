// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>

namespace app::dxf {

bool isBinary(const QByteArray& begin); ///< whether a file with these first bytes is binary DXF

/// A binary DXF file as text, up to where it ends or is damaged.
QByteArray textOfBinary(const QByteArray& bytes);

} // namespace app::dxf

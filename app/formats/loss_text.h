// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/formats/format.h"

namespace app {

/// "3 texts and 1 mask cannot be kept." Empty if nothing was lost.
QString lossSentence(const std::vector<Loss>& report);

/// The same, and that clip paths were cut: why Save becomes Save as. Empty if it does not.
QString saveAsReason(const std::vector<Loss>& report);

/// "plan.dxf was opened with a change: 1 file without a unit was read in millimetres." For a report
/// of remarks alone, at least one.
QString changesSentence(const QString& name, const std::vector<Loss>& report);

/// One line for each entry of the report: first the losses, then the remarks.
QStringList lossLines(const std::vector<Loss>& report);

/// "line 12", or "first in line 12" if it occurred several times; empty if it has no line.
QString whereText(const Loss& loss);

} // namespace app

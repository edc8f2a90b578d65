// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/teaching/narration.h"

#include <array>

// The words and numbers of a trace.

namespace app {

QString valueText(const Variable& variable)
{
    switch (variable.kind) {
    case clipping::ValueKind::Bits:
        return outcodeText(unsigned(variable.value));
    case clipping::ValueKind::Truth:
        return variable.value != 0 ? Text::tr("yes") : Text::tr("no");
    default:
        return exactText(variable.value);
    }
}

} // namespace app

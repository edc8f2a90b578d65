// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/comparison/at_text.h"

#include "app/base/text.h"

namespace app {

QString atText(const ComparedWindow& window)
{
    return window.isPage ? Text::tr("At the page: no clip window along the axes.") : QString();
}

} // namespace app

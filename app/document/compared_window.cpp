// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/compared_window.h"

namespace app {

ComparedWindow comparedWindow(const ClipWindows& windows, const Page& page)
{
    for (const ClipWindow& window : windows.list)
        if (const auto box = axisAlignedBox(window.shape); box && window.visible)
            return {*box, false};
    return {page.rectangle(), true};
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/export/export_choice.h"

#include "app/base/text.h"

#include <algorithm>

namespace app {

std::vector<const Format*> exportFormats()
{
    std::vector<const Format*> all;
    for (const Format& format : formats())
        if (format.write)
            all.push_back(&format);
    std::ranges::stable_partition(all, [](const Format* format) { return format->takes.paper; });
    return all;
}

const Format& formatOf(const ExportChoice& choice)
{
    const Format* format = findFormat(latin(choice.format));
    return format && format->write ? *format : *exportFormats().front();
}

} // namespace app

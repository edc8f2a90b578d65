// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/formats/csv/reader.h"
#include "app/formats/csv/writer.h"

namespace app {

Format csvFormat()
{
    return {"csv",
            Text::tr("CSV table of lines"),
            csv::read,
            csv::write,
            Holds::SeparateLines,
            StoresHidden::No,
            Text::tr("%1 layers (further layers become one), and as many lines as memory holds")
                .arg(countText(Containers::mostLayers)),
            Text::tr("coordinates"),
            {.precision = true}};
}

} // namespace app

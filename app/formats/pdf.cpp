// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/formats/pdf/writer.h"

namespace app {

Format pdfFormat()
{
    return {.key = "pdf",
            .name = Text::tr("PDF document"),
            .read = nullptr,
            .write = pdf::write,
            .purpose = Text::tr("print"),
            .takes = {.background = true, .precision = true, .paper = true}};
}

} // namespace app

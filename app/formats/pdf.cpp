// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/pdf/writer.h"

#include <QCoreApplication>

namespace app {

Format pdfFormat()
{
    return {"pdf", QCoreApplication::translate("formats", "PDF document"), nullptr, pdf::write};
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/formats/pdf/writer.h"

namespace app {

Format pdfFormat() { return {"pdf", Text::tr("PDF document"), nullptr, pdf::write}; }

} // namespace app

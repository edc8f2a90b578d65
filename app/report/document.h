// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/report/report.h"
#include "app/view/chart_look.h"

#include <memory>

class QTextDocument;

namespace app {

/// A report as rich text for pages of `dotsPerInch`, with charts painted as vectors.
std::unique_ptr<QTextDocument> documentOf(const Report& report, int dotsPerInch);

/// The colours of such a document.
ChartLook documentLook();

} // namespace app

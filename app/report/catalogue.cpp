// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/report/report.h"

#include <array>

namespace app {

// Each is defined in the file of its format.
std::optional<QString> writeHtmlReport(const Report& report, QIODevice& out);
std::optional<QString> writePdfReport(const Report& report, QIODevice& out);

QString readable(const QString& field, bool numeric)
{
    return numeric && field.startsWith(u'-') ? QChar(0x2212) + field.sliced(1) : field;
}

// THE CATALOGUE. To add a format: write its file in app/report/, and name it above and below.
std::span<const ReportFormat> reportFormats()
{
    static const std::array all{ReportFormat{"html", Text::tr("Web page"), writeHtmlReport},
                                ReportFormat{"pdf", Text::tr("PDF document"), writePdfReport}};
    return all;
}

std::optional<QString> writeReport(const Report& report, const QString& path)
{
    return writeAs(reportFormats(), path, report);
}

} // namespace app

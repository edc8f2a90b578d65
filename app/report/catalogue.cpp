// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/replace_file.h"
#include "app/base/text.h"
#include "app/report/report.h"

#include <QFileInfo>

#include <algorithm>

namespace app {

// Each is defined in the file of its format.
std::optional<QString> writeHtmlReport(const Report& report, QIODevice& out);
std::optional<QString> writePdfReport(const Report& report, QIODevice& out);

namespace {

QString endings()
{
    QStringList all;
    for (const ReportFormat& format : reportFormats())
        all << u'.' + format.key;
    return all.join(Text::tr(" or "));
}

} // namespace

QString readable(const QString& field, bool numeric)
{
    return numeric && field.startsWith(u'-') ? QChar(0x2212) + field.sliced(1) : field;
}

// THE CATALOGUE. To add a format: write its file in app/report/, and name it above and below.
std::vector<ReportFormat> reportFormats()
{
    return {
        {"html", Text::tr("Web page"), writeHtmlReport},
        {"pdf", Text::tr("PDF document"), writePdfReport},
    };
}

std::optional<ReportFormat> reportFormatOf(const QString& path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    for (ReportFormat& format : reportFormats())
        if (format.key == ending)
            return std::move(format);
    return std::nullopt;
}

std::optional<QString> writeReport(const Report& report, const QString& path)
{
    const auto format = reportFormatOf(path);
    if (!format)
        return Text::tr("Cannot write %1: end the name of a report with %2.").arg(path, endings());
    const auto error =
        replaceFile(path, [&](QIODevice& out) { return format->write(report, out); });
    return error ? std::optional(Text::tr("Cannot write %1: %2").arg(path, *error)) : std::nullopt;
}

} // namespace app

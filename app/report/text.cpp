// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/write_all.h"
#include "app/report/report.h"

namespace app {

/// Plain text: titles, sentences and tables, without the charts.
std::optional<QString> writeTextReport(const Report& report, QIODevice& out)
{
    QStringList lines{report.title};
    lines += report.summary;
    for (const ReportSection& section : report.sections) {
        lines << QString() << section.title;
        lines += section.sentences;
        lines << section.code << tableFormats().front().text(section.tables);
    }
    const std::string text = (lines.join(u'\n') + u'\n').toStdString();
    return writeAll(out, text) ? std::nullopt : std::optional(out.errorString() + u'.');
}

} // namespace app

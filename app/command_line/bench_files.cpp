// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/bench_files.h"

#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/command_line/terminal.h"

#include <QFileInfo>

namespace app {
namespace {

QStringList endingsOf(StudyFile::Group group)
{
    QStringList endings;
    for (const StudyFile& file : studyFiles())
        if (file.group == group)
            endings << u'.' + file.ending;
    return endings;
}

/// "FILE.html|FILE.pdf".
QString namesOf(StudyFile::Group group)
{
    return endingsOf(group)
        .replaceInStrings(QStringLiteral("."), QStringLiteral("FILE."))
        .join(u'|');
}

BenchFile fileFor(const QString& option, const QString& path, StudyFile::Group group)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    for (StudyFile& kind : studyFiles())
        if (kind.group == group && kind.ending == ending)
            return {std::move(kind), path};
    throw WrongUsage{Text::tr("--%1 %2: give a name that ends with %3.")
                         .arg(option, path, endingsOf(group).join(Text::tr(" or ")))};
}

} // namespace

std::vector<Option> fileOptions()
{
    return {
        {{"report"},
         namesOf(StudyFile::Group::Report),
         Text::tr("Also write a report: results, charts, tables, times by class, operations, "
                  "accuracy, and how it was measured.")},
        {{"charts"},
         namesOf(StudyFile::Group::Charts),
         Text::tr("Also write the charts: FILE-table1-clip-published.svg and so on.")},
    };
}

std::vector<BenchFile> parsedFiles(const ParsedArguments& arguments)
{
    std::vector<BenchFile> files;
    for (const auto& [option, group] :
         {std::pair(QStringLiteral("report"), StudyFile::Group::Report),
          std::pair(QStringLiteral("charts"), StudyFile::Group::Charts)})
        if (const auto path = arguments.text(option))
            files.push_back(fileFor(option, *path, group));
    for (const BenchFile& file : files)
        if (const QString folder = QFileInfo(file.path).path(); !QFileInfo(folder).isDir())
            throw Failure{
                Text::tr("Cannot write %1: there is no folder %2.").arg(file.path, folder)};
    return files;
}

void writeFiles(const std::vector<BenchFile>& files, const Study& study)
{
    for (const BenchFile& file : files) {
        const auto written = file.kind.write(study, file.path, {});
        if (!written)
            throw Failure{written.error};
        for (const QString& path : *written.value)
            say(Text::tr("Wrote %1").arg(path));
    }
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/command_line/parsed_arguments.h"
#include "app/command_line/terminal.h"
#include "app/lessons/course.h"
#include "app/lessons/lesson_files.h"
#include "app/lessons/lesson_page.h"

#include <QFileInfo>

#include <algorithm>

namespace app {
namespace {

/// The paths after "check" or "export".
QStringList lessonPaths(const ParsedArguments& arguments) { return arguments.operands().sliced(1); }

void checkLessons(const ParsedArguments& arguments)
{
    bool isGood = true;
    for (const LessonFile& file : readLessonFiles(lessonPaths(arguments))) {
        QString text = file.sentences().join(u'\n');
        if (file.faults.empty())
            text = Text::tr("%1: no fault (pages: %2, questions: %3).")
                       .arg(file.path)
                       .arg(file.lesson->pages.size())
                       .arg(questionsOf(*file.lesson));
        isGood = isGood && file.faults.empty();
        print(text + u'\n');
    }
    if (!isGood)
        throw CheckFailed{};
}

QString lessonKeys()
{
    QStringList keys;
    for (const Lesson& one : lessons())
        keys << one.key;
    return keys.join(Text::tr(", "));
}

/// A lesson of the program by its key, its title or its number in the list, or of a file.
Lesson lessonToExport(const QString& name)
{
    const auto& all = lessons();
    for (std::size_t i = 0; i < all.size(); ++i)
        if (all[i].key == name || all[i].title.compare(name, Qt::CaseInsensitive) == 0
            || QString::number(i + 1) == name)
            return all[i];
    if (!QFileInfo::exists(name))
        throw Failure{Text::tr("There is no lesson and no file “%1”. Give a file, or one of %2.")
                          .arg(name, lessonKeys())};
    const auto files = readLessonFiles({name});
    for (const LessonFile& file : files)
        for (const QString& sentence : file.sentences())
            say(sentence);
    if (files.size() != 1 || !files.front().lesson)
        throw Failure{files.size() > 1
                          ? Text::tr("%1 has several lessons; name one file.").arg(name)
                          : Text::tr("%1 was not exported.").arg(name)};
    return *files.front().lesson;
}

void exportLesson(const ParsedArguments& arguments)
{
    arguments.choice(QStringLiteral("format"), {"html"});
    const QStringList names = lessonPaths(arguments);
    if (names.size() > 1)
        throw WrongUsage{Text::tr("The argument “%1” is one too many.").arg(names[1])};
    const Lesson lesson = lessonToExport(names.front());
    const QString output = arguments.text(QStringLiteral("output")).value_or(QStringLiteral("-"));
    if (output == u"-") {
        const auto html = lessonHtml(lesson);
        if (!html)
            throw Failure{html.error};
        return print(QString::fromUtf8(*html.value));
    }
    if (const auto error = writeLessonPage(lesson, output))
        throw Failure{*error};
    say(Text::tr("Wrote %1").arg(output));
}

void lesson(const ParsedArguments& arguments)
{
    const QString what = arguments.operands().front();
    if (what == u"check")
        return checkLessons(arguments);
    if (what == u"export")
        return exportLesson(arguments);
    throw WrongUsage{
        Text::tr("There is no “lesson %1”; there are lesson check and lesson export.").arg(what)};
}

} // namespace

Command lessonCommand()
{
    return {"lesson",
            "check FILE|FOLDER… | export LESSON [-o PAGE.html]",
            Text::tr("Checks lessons that you wrote, or writes a lesson as one web page that needs "
                     "no network. “check” names file, line and fault, a sentence each; the exit "
                     "code is 3 if there is one."),
            {{{"f", "format"}, "html", Text::tr("Format of the page.")},
             {{"o", "output"},
              "FILE",
              Text::tr("Where to write the page (standard output). LESSON is a file or one of %1.")
                  .arg(lessonKeys())}},
            {"clearcut lesson check my-lessons/",
             "clearcut lesson export outcodes -o outcodes.html",
             "clearcut lesson export my-lessons/hexagons.md -o hexagons.html"},
            2,
            lesson,
            Paints::Pictures,
            {Text::tr("Lesson files have at most 1 MB, 100 pages, and 10,000 characters a page; "
                      "pictures beside them are PNG files of at most 5 MB.")},
            false,
            true};
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/lesson_page.h"

#include "app/base/replace_file.h"
#include "app/base/text.h"
#include "app/base/write_all.h"
#include "app/lessons/lesson_page_parts.h"
#include "app/lessons/markdown_html.h"
#include "app/teaching/trace_page_parts.h"

#include <QFile>

#include <array>

namespace app {

namespace {

constexpr std::uint64_t mostLines = 4; // about which a question can be
/// Widths of pictures in pixels: the first with which the page is small enough.
constexpr std::array pictureWidths{560, 400, 280};

QByteArray ofLesson(const char* name)
{
    QFile file(QStringLiteral(":/lesson_page/") + QLatin1StringView(name));
    return file.open(QIODevice::ReadOnly) ? file.readAll() : QByteArray();
}

QByteArray pageButton(const char* id, const QString& text, const QString& tip)
{
    return QByteArray("<button type=\"button\" id=\"") + id + "\" title=\""
           + tip.toHtmlEscaped().toUtf8() + "\">" + text.toHtmlEscaped().toUtf8() + "</button>\n";
}

QByteArray barHtml()
{
    return "<nav id=\"bar\" hidden>\n"
           + pageButton("back", Text::tr("Back"), Text::tr("Previous page (Page Up)"))
           + "<span id=\"place\"></span>\n<span id=\"score\"></span>\n"
           + pageButton("skip", Text::tr("Skip"),
                        Text::tr("Go on without an answer. The question then does not count as "
                                 "right."))
           + pageButton("next", Text::tr("Next"), Text::tr("Next page (Page Down)")) + "</nav>\n";
}

/// The right answers, for paper and for browsers without scripts.
QByteArray answersHtml(const Lesson& lesson)
{
    QByteArray html = "<section class=\"answers\">\n<h2>"
                      + Text::tr("Answers").toHtmlEscaped().toUtf8() + "</h2>\n<ol>\n";
    for (const LessonPage& page : lesson.pages)
        if (const QString answer = rightAnswer(page, 1); !answer.isEmpty())
            html += "<li>" + answer.toHtmlEscaped().toUtf8() + "</li>\n";
    return html + "</ol>\n</section>\n";
}

/// A page with the lines `about`.
QByteArray articleHtml(const LessonPage& page, const QString& place, const QByteArray& picture,
                       const QByteArray& about)
{
    return "<article class=\"page\">\n" + paragraphHtml("place", place) + picture
           + "<div class=\"text\">\n" + markdownHtml(page.text) + "</div>\n" + about
           + (page.shows.code ? codeHtml(narrationOf(page.tracedLine).code) : QByteArray())
           + "</article>\n";
}

using Parts = std::vector<QByteArray>; // one for each page

Parts linesHtml(const std::vector<LessonPage>& pages, std::uint64_t seed)
{
    Parts lines;
    for (const LessonPage& page : pages)
        lines.push_back(seed == 1 || !page.families.isEmpty() ? lineHtml(page, seed)
                                                              : QByteArray());
    return lines;
}

Parts picturesHtml(const std::vector<LessonPage>& pages, int width)
{
    Parts pictures;
    for (const LessonPage& page : pages)
        pictures.push_back(pictureHtml(page.picture, width));
    return pictures;
}

qsizetype sizeOf(const Parts& parts)
{
    qsizetype size = 0;
    for (const QByteArray& part : parts)
        size += part.size();
    return size;
}

/// The pages with these pictures and lines.
QByteArray articlesHtml(const std::vector<LessonPage>& pages, const Parts& pictures,
                        const Parts& about)
{
    QByteArray html;
    for (std::size_t i = 0; i < pages.size(); ++i)
        html += articleHtml(pages[i], Text::tr("%1 of %2").arg(i + 1).arg(pages.size()),
                            pictures[i], about[i]);
    return html;
}

} // namespace

Result<QByteArray> lessonHtml(const Lesson& lesson)
{
    const auto& pages = lesson.pages;
    const QByteArray before = pageHeadHtml(lesson.title, ofLesson("lesson.css"))
                              + "<body>\n<header>\n<h1>" + lesson.title.toHtmlEscaped().toUtf8()
                              + "</h1>\n" + paragraphHtml("summary", lesson.summary) + "</header>\n"
                              + barHtml() + "<main>\n";
    const QByteArray after = "</main>\n<section id=\"ending\" hidden>\n<p id=\"verdict\"></p>\n"
                             + pageButton("repeat", Text::tr("Repeat lesson"),
                                          Text::tr("Start this lesson again, with other lines"))
                             + "</section>\n" + answersHtml(lesson) + lessonWordsHtml(lesson)
                             + "<script>\n" + ofLesson("lesson.js")
                             + "</script>\n</body>\n</html>\n";
    Parts about = linesHtml(pages, 1), pictures(pages.size());
    qsizetype room = mostLessonPageBytes - before.size() - after.size()
                     - articlesHtml(pages, pictures, about).size();
    for (const int width : pictureWidths)
        if (pictures = picturesHtml(pages, width); sizeOf(pictures) <= room)
            break;
    room -= sizeOf(pictures);
    if (room < 0)
        return Result<QByteArray>::failure(
            Text::tr("The page would have more than %1 kB. Divide the lesson, or leave pictures "
                     "out.")
                .arg(mostLessonPageBytes / 1000));
    for (std::uint64_t seed = 2; seed <= mostLines; ++seed) {
        const Parts more = linesHtml(pages, seed);
        room -= sizeOf(more);
        for (std::size_t i = 0; i < pages.size() && room >= 0; ++i)
            about[i] += more[i];
    }
    return Result<QByteArray>::of(before + articlesHtml(pages, pictures, about) + after);
}

std::optional<QString> writeLessonPage(const Lesson& lesson, const QString& path)
{
    const auto html = lessonHtml(lesson);
    if (!html)
        return html.error;
    const auto error = replaceFile(path, [&](QIODevice& out) -> std::optional<QString> {
        if (writeAll(out, {html.value->data(), std::size_t(html.value->size())}))
            return std::nullopt;
        return out.errorString() + u'.';
    });
    return error ? std::optional(Text::tr("Cannot write %1: %2").arg(path, *error)) : std::nullopt;
}

} // namespace app

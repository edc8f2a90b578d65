// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/lesson_page_parts.h"

#include "app/base/text.h"
#include "app/formats/format.h"
#include "app/lessons/attempt.h"
#include "app/lessons/course.h"
#include "app/lessons/markdown_html.h"
#include "app/teaching/figure_svg.h"
#include "app/teaching/figure_text.h"
#include "app/teaching/trace_page_parts.h"
#include "app/view/thumbnail.h"

#include <QBuffer>
#include <QFile>
#include <QImageReader>
#include <QJsonDocument>
#include <QJsonObject>

namespace app {

namespace {

constexpr QSizeF lineFigureSize(480, 340);

QByteArray plain(const QString& text) { return text.toHtmlEscaped().toUtf8(); }

/// A page about a line, with its steps as they are known before the question is answered.
struct LinePage {
    LessonPage page;
    Narration all, known;
    std::size_t step; ///< that the page shows, once all are known
    std::optional<Question> question;
};

LinePage linePageOf(const LessonPage& written, std::uint64_t seed)
{
    LinePage at{drawnPage(written, seed), {}, {}, 0, {}};
    at.all = at.known = narrationOf(at.page.tracedLine);
    at.step = wantedStep(at.page, at.all);
    at.question = questionOf(at.page, at.all, at.step);
    if (!at.question)
        return at;
    at.question = inNewOrder(*at.question, seed);
    const std::size_t shown = stepsShown(at.page, at.step);
    at.known.steps.resize(std::min(shown, at.known.steps.size()));
    at.known.visible.reset();
    return at;
}

QByteArray figureHtml(const LinePage& at, const Narration& narration)
{
    const TraceStep step{at.page.tracedLine, narration, at.step};
    return "<svg class=\"figure\" viewBox=\"0 0 " + QByteArray::number(lineFigureSize.width()) + ' '
           + QByteArray::number(lineFigureSize.height()) + "\" role=\"img\" aria-label=\""
           + plain(figureText(at.page.tracedLine, narration, at.step)) + "\">\n"
           + figureSvg(step, lineFigureSize) + "</svg>\n";
}

/// The parts beside the figure that a page shows, up to the open step.
QByteArray besideHtml(const LinePage& at, const Narration& narration)
{
    const LessonParts& shows = at.page.shows;
    if (at.step >= narration.steps.size())
        return {};
    const NarratedStep& narrated = narration.steps[at.step];
    QByteArray html = shows.steps ? paragraphHtml("sentence", narrated.sentence) : QByteArray();
    if (shows.code && narrated.line >= 1 && narrated.line <= narration.code.size())
        html += "<p class=\"line\">" + plain(Text::tr("Line %1: ").arg(narrated.line)) + "<code>"
                + plain(narration.code[narrated.line - 1].trimmed()) + "</code></p>\n";
    const QByteArray tables =
        (shows.variables ? variablesHtml(narrated) : QByteArray())
        + (shows.operations ? operationsHtml(narration, at.step) : QByteArray());
    return tables.isEmpty() ? html : html + "<div class=\"values\">\n" + tables + "</div>\n";
}

QByteArray questionHtml(const Question& question)
{
    QByteArray html = "<form class=\"ask\" data-right=\"" + QByteArray::number(question.right)
                      + "\">\n<fieldset><legend>" + plain(question.prompt) + "</legend>\n";
    for (const QString& choice : question.choices)
        html += "<button type=\"button\" class=\"choice\">" + plain(choice) + "</button>\n";
    return html + "<button type=\"button\" class=\"show\" hidden>"
           + plain(Text::tr("Show the answer"))
           + "</button>\n</fieldset>\n<p class=\"verdict\" aria-live=\"polite\"></p>\n"
             "<template class=\"hint\">"
           + plain(question.hint) + "</template>\n<template class=\"reason\">"
           + plain(question.reason) + "</template>\n</form>\n";
}

QByteArray pngOf(const QImage& image)
{
    QBuffer buffer;
    buffer.open(QIODevice::WriteOnly);
    image.save(&buffer, "PNG");
    return buffer.data();
}

QImage imageOf(const QString& picture, int width)
{
    constexpr int high = 9, wide = 16;
    const QString sample = QStringLiteral(":/samples/%1.svg").arg(picture);
    if (!QFile::exists(sample))
        return QImageReader(picture, "png").read();
    const auto drawing = readFile(sample);
    const FigureColours colours = figureColours(Ground::Light);
    return drawing ? thumbnail(drawing.value->document, {width, width * high / wide}, 1,
                               {Qt::white, colours.window, 0.3})
                   : QImage();
}

} // namespace

QByteArray lineHtml(const LessonPage& page, std::uint64_t seed)
{
    const LinePage at = linePageOf(page, seed);
    QByteArray html = "<section class=\"about\">\n";
    if (!at.question)
        return html + figureHtml(at, at.all) + besideHtml(at, at.all) + "</section>\n";
    const bool changes = at.known.steps.size() <= at.step; // the answered page shows another step
    const QByteArray answered =
        changes ? figureHtml(at, at.all) + besideHtml(at, at.all) : QByteArray();
    html += "<div class=\"asked\">\n" + figureHtml(at, at.known) + besideHtml(at, at.known)
            + "</div>\n";
    if (changes)
        html += "<div class=\"answered\" hidden>\n" + answered + "</div>\n";
    html += questionHtml(*at.question);
    if (!page.told.isEmpty())
        html += "<div class=\"told\" hidden>\n" + markdownHtml(page.told) + "</div>\n";
    return html + "</section>\n";
}

QString rightAnswer(const LessonPage& page, std::uint64_t seed)
{
    const auto question = linePageOf(page, seed).question;
    return question ? question->choices[question->right] + QStringLiteral(". ") + question->reason
                    : QString();
}

QByteArray pictureHtml(const QString& picture, int width)
{
    QImage image = picture.isEmpty() ? QImage() : imageOf(picture, width);
    if (image.isNull())
        return {};
    if (image.width() > width)
        image = image.scaledToWidth(width, Qt::SmoothTransformation);
    return "<img class=\"picture\" alt=\"\" src=\"data:image/png;base64,"
           + pngOf(image.convertToFormat(QImage::Format_RGB888)).toBase64() + "\">\n";
}

QByteArray lessonWordsHtml(const Lesson& lesson)
{
    const QJsonObject words{
        {"place", Text::tr("%1 of %2")},
        {"right", Text::tr("Right. %1")},
        {"wrong", Text::tr("Not quite. %1")},
        {"again", Text::tr("Not quite. You have one more try. Hint: %1")},
        {"score", Text::tr("%1 of %2 right, %3 pass")},
        {"passed", Text::tr("Passed: %1 of %2 right at the first try.")},
        {"failed", Text::tr("Not passed yet: %1 of %2 right at the first try, and %3 are needed. "
                            "Try the lesson again? It then has other lines.")},
        {"questions", questionsOf(lesson)},
        {"needed", neededRight(lesson)},
    };
    QByteArray json = QJsonDocument(words).toJson(QJsonDocument::Compact);
    json.replace('<', "\\u003c"); // no word ends the script
    return "<script type=\"application/json\" id=\"words\">" + json + "</script>\n";
}

} // namespace app

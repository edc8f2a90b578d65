// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/lesson.h"

#include "app/base/text.h"
#include "app/lessons/families.h"

#include <QFile>

#include <algorithm>
#include <array>

namespace app {

namespace {

/// "-160,-30": two numbers with a comma.
std::optional<Point> pointOf(const QString& word)
{
    const QStringList parts = word.split(u',');
    if (parts.size() != 2)
        return std::nullopt;
    bool x = false, y = false;
    const Point point(parts[0].toDouble(&x), parts[1].toDouble(&y));
    return x && y ? std::optional(point) : std::nullopt;
}

/// "look KEY line X,Y X,Y window X,Y X,Y"
std::optional<TracedLine> tracedLineOf(const QStringList& words)
{
    if (words.size() != 8 || words[2] != QStringLiteral("line")
        || words[5] != QStringLiteral("window"))
        return std::nullopt;
    const auto variant = findVariant(words[1]);
    const auto a = pointOf(words[3]), b = pointOf(words[4]);
    const auto min = pointOf(words[6]), max = pointOf(words[7]);
    if (!variant || !a || !b || !min || !max)
        return std::nullopt;
    return TracedLine{*variant, {*a, *b}, {*min, *max}, YAxis::Up, {}};
}

/// The step that a page shows: the index among all steps, or among those with a mark, from 1.
struct WantedStep {
    std::optional<Mark> mark;
    std::size_t which;
};

/// "first", "last", "7"; "cut", or "cut-2" for the second cut. Empty for any other word.
std::optional<WantedStep> stepOf(const QString& word)
{
    struct Row {
        const char* word;
        WantedStep step;
    };
    static constexpr std::size_t beyondAll = -1;
    static constexpr std::array rows{
        Row{"", {{}, 1}},
        Row{"first", {{}, 1}},
        Row{"last", {{}, beyondAll}},
        Row{"look", {Mark::Look, 1}},
        Row{"compare", {Mark::Compare, 1}},
        Row{"divide", {Mark::Divide, 1}},
        Row{"cut", {Mark::Cut, 1}},
        Row{"accept", {Mark::Accept, 1}},
        Row{"reject", {Mark::Reject, 1}},
    };
    bool isNumber = false;
    if (const uint number = word.toUInt(&isNumber); isNumber)
        return number > 0 ? std::optional(WantedStep{{}, number}) : std::nullopt;
    const QStringList parts = word.split(u'-');
    const auto row = std::ranges::find_if(
        rows, [&](const Row& r) { return parts[0] == QLatin1StringView(r.word); });
    if (row == rows.end() || parts.size() > 2)
        return std::nullopt;
    if (parts.size() == 1)
        return row->step;
    const uint which = parts[1].toUInt(&isNumber);
    return row->step.mark && isNumber && which > 0
               ? std::optional(WantedStep{row->step.mark, which})
               : std::nullopt;
}

/// "code variables": the parts that a page shows; "nothing" for none. Empty for any other word.
std::optional<LessonParts> partsOf(const QStringList& words)
{
    struct Row {
        const char* word;
        bool LessonParts::*part;
    };
    static constexpr std::array rows{
        Row{"code", &LessonParts::code}, Row{"variables", &LessonParts::variables},
        Row{"operations", &LessonParts::operations}, Row{"steps", &LessonParts::steps}};
    LessonParts parts;
    if (words == QStringList(QStringLiteral("nothing")))
        return parts;
    for (const QString& word : words) {
        const auto row = std::ranges::find_if(
            rows, [&](const Row& r) { return word == QLatin1StringView(r.word); });
        if (row == rows.end())
            return std::nullopt;
        parts.*row->part = true;
    }
    return words.isEmpty() ? std::nullopt : std::optional(parts);
}

/// The state of the parser.
struct Reading {
    Lesson lesson;
    LessonPage page;
    bool looked = false; ///< some page has defined a traced line

    /// Parses one line; returns false if it is wrong.
    bool take(const QString& line)
    {
        if (line.startsWith(QStringLiteral(":: ")))
            return obey(line.mid(3).split(u' ', Qt::SkipEmptyParts));
        if (line == QStringLiteral("---"))
            return endPage();
        if (lesson.title.isEmpty() && line.startsWith(QStringLiteral("# ")))
            lesson.title = line.mid(2);
        else if (lesson.summary.isEmpty() && line.startsWith(QStringLiteral("> ")))
            lesson.summary = line.mid(2);
        else
            (page.question ? page.told : page.text) += line + u'\n';
        return true;
    }
    bool obey(const QStringList& words)
    {
        const QString what = words.value(0);
        if (what == QStringLiteral("look")) {
            const auto tracedLine = tracedLineOf(words);
            if (tracedLine)
                page.tracedLine = *tracedLine;
            looked = looked || tracedLine;
            return tracedLine.has_value();
        }
        if (what == QStringLiteral("shows")) {
            const auto parts = partsOf(words.mid(1));
            page.shows = parts.value_or(page.shows);
            return parts.has_value();
        }
        if (what == QStringLiteral("draw"))
            return draw(words.mid(1));
        if (what == QStringLiteral("step") && words.size() == 2 && stepOf(words[1]))
            page.step = words[1];
        else if (what == QStringLiteral("picture") && words.size() == 2)
            page.picture = words[1];
        else if (what == QStringLiteral("ask") && words.size() >= 2 && !page.question)
            page.question = QuestionSpec{words[1], words.mid(2)};
        else if (what == QStringLiteral("hint") && words.size() >= 2 && page.question)
            page.hint = words.mid(1).join(u' ');
        else
            return false;
        return true;
    }
    bool draw(const QStringList& families)
    {
        page.families = families;
        return !families.isEmpty()
               && std::ranges::all_of(families, [](const QString& f) { return findLineFamily(f); });
    }
    bool endPage()
    {
        page.text = page.text.trimmed();
        page.told = page.told.trimmed();
        if (page.text.isEmpty() || !looked)
            return false;
        page.tracedLine.origin = lesson.title;
        lesson.pages.push_back(page);
        // The next page keeps the traced line and the parts.
        page = {.text = {}, .tracedLine = page.tracedLine, .shows = page.shows};
        return true;
    }
};

// THE CATALOGUE. To add a lesson: write its file in resources/lessons/, and add its key here.
// clang-format off
constexpr std::array keys{
    "why-clip",
    "outcodes",
    "parameters",
    "avoiding-divisions",
    "method-2019",
    "rounding",
};
// clang-format on

} // namespace

Result<Lesson> readLesson(const QString& key, const QString& text)
{
    Reading reading{.lesson = {.key = key, .title = {}, .summary = {}, .pages = {}}, .page = {}};
    int number = 0;
    for (const QString& line : text.split(u'\n')) {
        ++number;
        if (!line.startsWith(QStringLiteral("<!--")) && !reading.take(line))
            return Result<Lesson>::failure(
                Text::tr("line %1: “%2” is not understood. No lesson was read.")
                    .arg(number)
                    .arg(line));
    }
    if (!reading.endPage() || reading.lesson.title.isEmpty())
        return Result<Lesson>::failure(
            Text::tr("line %1: the last page has no text, or no page has a “look” line.")
                .arg(number));
    return Result<Lesson>::of(reading.lesson);
}

const std::vector<Lesson>& lessons()
{
    static const std::vector<Lesson> all = [] {
        std::vector<Lesson> read;
        for (const char* key : keys) {
            const QString name = QString::fromLatin1(key);
            QFile file(QStringLiteral(":/lessons/%1.md").arg(name));
            if (file.open(QIODevice::ReadOnly))
                if (auto lesson = readLesson(name, QString::fromUtf8(file.readAll())))
                    read.push_back(*lesson.value);
        }
        return read;
    }();
    return all;
}

std::optional<std::size_t> stepFor(const LessonPage& page, const Narration& narration)
{
    const auto wanted = stepOf(page.step);
    const std::size_t count = narration.steps.size();
    if (!wanted || count == 0)
        return std::nullopt;
    if (page.step == u"last")
        return count - 1;
    std::size_t left = wanted->which;
    for (std::size_t i = 0; i < count; ++i)
        if ((!wanted->mark || narration.steps[i].mark == *wanted->mark) && --left == 0)
            return i;
    return std::nullopt;
}

std::size_t wantedStep(const LessonPage& page, const Narration& narration)
{
    return stepFor(page, narration).value_or(std::max<std::size_t>(narration.steps.size(), 1) - 1);
}

} // namespace app

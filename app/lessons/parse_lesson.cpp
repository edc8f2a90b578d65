// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/parse_lesson.h"

#include "app/base/text.h"
#include "app/lessons/families.h"
#include "app/lessons/lesson_step.h"
#include "app/lessons/question.h"

#include <algorithm>
#include <array>

namespace app {

namespace {

constexpr std::size_t mostFaults = 20;
constexpr qsizetype mostText = 10'000, mostTitle = 200, mostSummary = 500;

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

template <class Rows, class Key>
QString keysOf(const Rows& rows, Key key)
{
    QStringList words;
    for (const auto& row : rows)
        words << latin(row.*key);
    return words.join(Text::tr(", "));
}

/// A part of a page by its word after “:: shows”.
struct PartRow {
    std::string_view word;
    bool LessonParts::*part;
};
constexpr std::array partRows{
    PartRow{"code", &LessonParts::code}, PartRow{"variables", &LessonParts::variables},
    PartRow{"operations", &LessonParts::operations}, PartRow{"steps", &LessonParts::steps}};

/// "code variables": the parts that a page shows; "nothing" for none. Empty for any other word.
std::optional<LessonParts> partsOf(const QStringList& words)
{
    LessonParts parts;
    if (words == QStringList(QStringLiteral("nothing")))
        return parts;
    for (const QString& word : words) {
        const auto row =
            std::ranges::find_if(partRows, [&](const PartRow& r) { return word == latin(r.word); });
        if (row == partRows.end())
            return std::nullopt;
        parts.*row->part = true;
    }
    return words.isEmpty() ? std::nullopt : std::optional(parts);
}

/// A word of the file in a message, where it may be of any length.
QString quoted(const QString& word)
{
    constexpr qsizetype most = 60;
    return u'“' + (word.size() > most ? word.first(most) + u'…' : word) + u'”';
}

/// The state of the parser.
class Parser {
public:
    explicit Parser(const QString& key) { parsed_.lesson.key = key; }
    ParsedLesson parse(const QString& text);

private:
    using Obey = void (Parser::*)(const QStringList& words);
    struct Instruction {
        std::string_view word;
        Obey obey;
    };
    static const std::array<Instruction, 8> instructions;

    bool isFull() const { return parsed_.faults.size() >= mostFaults; }
    void fault(QString sentence, int line = 0)
    {
        parsed_.faults.push_back({line > 0 ? line : number_, std::move(sentence)});
    }
    void take(const QString& line);
    void obey(const QStringList& words);
    void addText(const QString& line);
    void endPage();

    void version(const QStringList& words);
    void look(const QStringList& words);
    void draw(const QStringList& words);
    void step(const QStringList& words);
    void shows(const QStringList& words);
    void picture(const QStringList& words);
    void ask(const QStringList& words);
    void hint(const QStringList& words);

    ParsedLesson parsed_;
    LessonPage page_{};
    PageLines lines_{};
    int number_ = 0;
    std::size_t faultsBefore_ = 0; ///< before the page
    bool obeyed_ = false;    ///< there was an instruction
    bool looked_ = false;    ///< some page has defined a traced line
    bool isTooLong_ = false; ///< so was said of this page
};

const std::array<Parser::Instruction, 8> Parser::instructions{{{"version", &Parser::version},
                                                               {"look", &Parser::look},
                                                               {"draw", &Parser::draw},
                                                               {"step", &Parser::step},
                                                               {"shows", &Parser::shows},
                                                               {"picture", &Parser::picture},
                                                               {"ask", &Parser::ask},
                                                               {"hint", &Parser::hint}}};

ParsedLesson Parser::parse(const QString& text)
{
    for (const QStringView line : QStringView(text).split(u'\n')) {
        ++number_;
        if (isFull() || parsed_.lesson.pages.size() > mostLessonPages)
            break;
        if (!line.startsWith(u"<!--"))
            take((line.endsWith(u'\r') ? line.chopped(1) : line).toString());
    }
    Lesson& lesson = parsed_.lesson;
    if (!obeyed_) {
        parsed_.faults = {{1, Text::tr("This is no lesson: no line begins with “::”.")}};
        return std::move(parsed_);
    }
    if (lesson.pages.size() > mostLessonPages)
        fault(Text::tr("A lesson has at most %1 pages. Divide it into several files.")
                  .arg(mostLessonPages));
    else if (!isFull())
        endPage();
    if (lesson.title.isEmpty())
        fault(Text::tr("A lesson needs a title: a line “# Title”."), 1);
    std::ranges::stable_sort(parsed_.faults, {}, &LessonFault::line);
    return std::move(parsed_);
}

void Parser::take(const QString& line)
{
    Lesson& lesson = parsed_.lesson;
    if (line.startsWith(u"::"))
        return obey(line.mid(2).simplified().split(u' '));
    if (line == u"---")
        return endPage();
    if (lesson.title.isEmpty() && line.startsWith(u"# "))
        lesson.title = line.mid(2, mostTitle).trimmed();
    else if (lesson.summary.isEmpty() && line.startsWith(u"> "))
        lesson.summary = line.mid(2, mostSummary).trimmed();
    else
        addText(line);
}

void Parser::addText(const QString& line)
{
    if (lines_.first == 0 && !line.isEmpty())
        lines_.first = number_;
    if (line.contains(u"![")) // would be read from any place, also one that never ends
        fault(Text::tr("A picture stands on a line of its own, “:: picture NAME.png”, not in the "
                       "text."));
    QString& text = page_.question ? page_.told : page_.text;
    if (text.size() + line.size() <= mostText)
        text += line + u'\n';
    else if (!std::exchange(isTooLong_, true))
        fault(Text::tr("The text of a page has at most %L1 characters. Divide the page with a line "
                       "“---”.")
                  .arg(mostText));
}

void Parser::obey(const QStringList& words)
{
    obeyed_ = true;
    if (lines_.first == 0)
        lines_.first = number_;
    const auto found = std::ranges::find_if(
        instructions, [&](const Instruction& i) { return words.front() == latin(i.word); });
    if (found != instructions.end())
        return (this->*found->obey)(words.sliced(1));
    fault(Text::tr("%1 is no instruction. There are %2.")
              .arg(quoted(QStringLiteral(":: ") + words.front()),
                   keysOf(instructions, &Instruction::word)));
}

void Parser::version(const QStringList& words)
{
    bool isNumber = false;
    const int version = words.value(0).toInt(&isNumber);
    if (!isNumber || words.size() != 1 || version < 1)
        return fault(Text::tr("Write the version of the lesson's format as “:: version %1”.")
                         .arg(lessonVersion));
    if (version > lessonVersion)
        fault(Text::tr("This lesson has version %1, and this Clearcut reads version %2. A newer "
                       "Clearcut may open it.")
                  .arg(version)
                  .arg(lessonVersion));
}

/// "look KEY line X,Y X,Y window X,Y X,Y"
void Parser::look(const QStringList& words)
{
    lines_.look = number_;
    looked_ = true; // not two faults for one mistake
    if (words.size() != 7 || words[1] != u"line" || words[4] != u"window")
        return fault(
            Text::tr("Write “:: look KEY line X,Y X,Y window XMIN,YMIN XMAX,YMAX”, numbers "
                     "without blanks beside the commas."));
    const auto variant = findVariant(words[0]);
    if (!variant)
        return fault(Text::tr("There is no algorithm %1. “clearcut algorithms” lists them all; add "
                              "“:published” to its key for the published form.")
                         .arg(quoted(words[0])));
    std::array<Point, 4> points{};
    constexpr std::array places{2, 3, 5, 6};
    for (std::size_t i = 0; i < places.size(); ++i) {
        const auto point = pointOf(words[places[i]]);
        if (!point)
            return fault(
                Text::tr("%1 is no point: write two numbers with a comma, such as “-160,30”.")
                    .arg(quoted(words[places[i]])));
        points[i] = *point;
    }
    page_.tracedLine =
        TracedLine{*variant, {points[0], points[1]}, {points[2], points[3]}, YAxis::Up, {}};
}

void Parser::draw(const QStringList& families)
{
    lines_.draw = number_;
    page_.families = families;
    const auto unknown = std::ranges::find_if_not(
        families, [](const QString& family) { return findLineFamily(family); });
    if (families.isEmpty() || unknown != families.end())
        fault((families.isEmpty()
                   ? Text::tr("“:: draw” names at least one family of lines.")
                   : Text::tr("There is no family of lines %1.").arg(quoted(*unknown)))
              + u' ' + Text::tr("There are %1.").arg(keysOf(lineFamilies(), &LineFamily::key)));
}

void Parser::step(const QStringList& words)
{
    lines_.step = number_;
    if (words.size() == 1 && isLessonStep(words[0]))
        page_.step = words[0];
    else
        fault(Text::tr("%1 names no step. Write first, last, a number from 1, look, compare, "
                       "divide, cut, accept or reject; cut-2 is the second cut.")
                  .arg(quoted(words.join(u' '))));
}

void Parser::shows(const QStringList& words)
{
    const auto parts = partsOf(words);
    page_.shows = parts.value_or(page_.shows);
    if (!parts)
        fault(Text::tr("“:: shows” has some of the words %1, or “nothing”.")
                  .arg(keysOf(partRows, &PartRow::word)));
}

void Parser::picture(const QStringList& words)
{
    lines_.picture = number_;
    page_.picture = words.join(u' ');
    if (words.isEmpty())
        fault(Text::tr("“:: picture” names a PNG file beside the lesson, or a sample."));
}

void Parser::ask(const QStringList& words)
{
    if (page_.question)
        return fault(Text::tr("A page asks at most one question. Begin the next page with a line "
                              "“---”."));
    lines_.ask = number_;
    page_.question = QuestionSpec{words.value(0), words.mid(1)};
    if (words.isEmpty() || choicesOf(*page_.question) == 0)
        fault(Text::tr("There is no question %1. There are %2.")
                  .arg(quoted(QStringLiteral(":: ask ") + words.value(0)),
                       keysOf(questionKinds(), &QuestionKind::key)));
}

void Parser::hint(const QStringList& words)
{
    if (!page_.question || words.isEmpty())
        fault(Text::tr("A hint stands below “:: ask” and is one sentence."));
    page_.hint = words.join(u' ').first(std::min(words.join(u' ').size(), mostSummary));
}

void Parser::endPage()
{
    page_.text = page_.text.trimmed();
    page_.told = page_.told.trimmed();
    const int first = lines_.first > 0 ? lines_.first : number_;
    const bool isFaulty = parsed_.faults.size() > faultsBefore_; // and was told so
    if (!looked_ && !isFaulty)
        fault(Text::tr("The page shows no line: the first page needs a “:: look”."), first);
    if (page_.text.isEmpty() && !isFaulty)
        fault(Text::tr("The page has no text before its question."), first);
    looked_ = true;
    page_.tracedLine.origin = parsed_.lesson.title;
    parsed_.lesson.pages.push_back(page_);
    parsed_.lines.push_back(lines_);
    // The next page keeps the traced line and the parts.
    page_ = {.text = {}, .tracedLine = page_.tracedLine, .shows = page_.shows};
    lines_ = {.look = lines_.look};
    faultsBefore_ = parsed_.faults.size();
    isTooLong_ = false;
}

} // namespace

ParsedLesson parseLesson(const QString& key, const QString& text)
{
    return Parser(key).parse(text);
}

} // namespace app

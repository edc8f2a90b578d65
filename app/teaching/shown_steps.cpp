// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/shown_steps.h"

#include "app/base/text.h"
#include "app/document/paper.h"

#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>
#include <string_view>

namespace app {

namespace {

constexpr qsizetype mostSteps = 60, mostPoints = 200, mostWords = 100, longestLine = 1000;
constexpr double farthest = 10'000;               // millimetres
constexpr std::size_t mostCopiedObjects = 20'000; // more than in any sample

using Kind = ShownStep::Kind;
using Words = QStringList;

std::optional<double> numberIn(const QString& text)
{
    bool isNumber = false;
    const double number = text.toDouble(&isNumber);
    return isNumber && std::abs(number) <= farthest ? std::optional(number) : std::nullopt;
}

std::optional<Point> pointIn(const QString& word)
{
    const Words parts = word.split(u',');
    const auto x = numberIn(parts.value(0)), y = numberIn(parts.value(1));
    return parts.size() == 2 && x && y ? std::optional(Point(*x, *y)) : std::nullopt;
}

/// The keys at the end that are held: "with Shift".
std::optional<Qt::KeyboardModifiers> takeModifiers(Words& words)
{
    Qt::KeyboardModifiers all;
    const auto at = words.indexOf(QStringLiteral("with"));
    for (const QString& word : at < 0 ? Words() : words.mid(at + 1))
        if (word == QStringLiteral("Shift"))
            all |= Qt::ShiftModifier;
        else if (word == QStringLiteral("Alt"))
            all |= Qt::AltModifier;
        else if (word == QStringLiteral("Ctrl"))
            all |= Qt::ControlModifier;
        else
            return std::nullopt;
    if (at >= 0)
        words.resize(at);
    return all;
}

template <qsizetype least, qsizetype most>
bool readPoints(Words words, ShownStep& step)
{
    const auto with = takeModifiers(words);
    if (!with || words.size() < least || words.size() > most)
        return false;
    step.with = *with;
    for (const QString& word : words)
        if (const auto point = pointIn(word))
            step.points.push_back(*point);
    return qsizetype(step.points.size()) == words.size();
}

bool readCommand(Words words, ShownStep& step)
{
    step.command = words.value(0);
    return words.size() == 1;
}

/// A word of more than one letter may name one key, as the pages write it: "Enter", "Ctrl+D".
std::optional<ShownStep::Key> namedKey(const QString& word)
{
    static const QRegularExpression name(
        QStringLiteral("^(?:(?:Ctrl|Shift|Alt)\\+)*(?:[A-Z][a-z]+|F\\d\\d?)$|"
                       "^(?:(?:Ctrl|Shift|Alt)\\+)+\\S$"));
    if (word.size() < 2 || !name.match(word).hasMatch())
        return std::nullopt;
    QString known = word;
    if (known.endsWith(QStringLiteral("Enter")))
        known = known.chopped(5) + QStringLiteral("Return");
    const QKeySequence keys(known, QKeySequence::PortableText);
    if (keys.count() != 1 || keys[0].key() == Qt::Key_unknown)
        return std::nullopt;
    return ShownStep::Key{keys[0],
                          keys[0].key() == Qt::Key_Space ? QStringLiteral(" ") : QString()};
}

/// A word of one letter is a key, as in "G 10,20 Enter"; in longer ones capitals are typed.
void addLetters(const QString& word, std::vector<ShownStep::Key>& keys)
{
    for (const QChar letter : word) {
        const bool isCapital = word.size() > 1 && letter.isUpper();
        keys.push_back({QKeyCombination(isCapital ? Qt::ShiftModifier : Qt::NoModifier,
                                        Qt::Key(letter.toUpper().unicode())),
                        isCapital ? letter : letter.toLower()});
    }
}

bool readTyped(Words words, ShownStep& step)
{
    step.typed = words.join(u' ');
    for (const QString& word : words)
        if (auto key = namedKey(word))
            step.keys.push_back(*key);
        else
            addLetters(word, step.keys);
    return !words.isEmpty() && words.size() <= mostWords;
}

bool readButton(Words words, ShownStep& step)
{
    step.button = words.join(u' ');
    return !words.isEmpty();
}

/// THE CATALOGUE of the kinds of steps.
struct KindInfo {
    std::string_view word;
    Kind kind;
    bool (*read)(Words words, ShownStep& step);
};
constexpr std::array kinds{
    KindInfo{"command", Kind::Command, readCommand},
    KindInfo{"move", Kind::Move, readPoints<1, 1>},
    KindInfo{"click", Kind::Click, readPoints<1, 1>},
    KindInfo{"double-click", Kind::DoubleClick, readPoints<1, 1>},
    KindInfo{"drag", Kind::Drag, readPoints<2, mostPoints>},
    KindInfo{"type", Kind::Type, readTyped},
    KindInfo{"press", Kind::Press, readButton},
};

/// "windows +1 objects 3"
bool readEnds(const Words& words, std::vector<ShownEnd>& ends)
{
    for (qsizetype i = 0; i + 1 < words.size(); i += 2) {
        const auto number = numberIn(words[i + 1]);
        if (!number)
            return false;
        ends.push_back({words[i], *number, words[i + 1].startsWith(u'+') || *number < 0});
    }
    return !words.isEmpty() && words.size() % 2 == 0;
}

/// "new", "landscape", "copy or landscape"
bool readPlace(Words words, ShownSteps& steps)
{
    steps.inCopy = words.value(0) == QStringLiteral("copy");
    if (steps.inCopy && words.value(1) == QStringLiteral("or"))
        words.remove(0, 2);
    if (words.size() == 1 && words[0] != QStringLiteral("new"))
        steps.sample = words[0];
    return words.size() == 1 && steps.sample != QStringLiteral("copy");
}

/// A line with what it shows, in quotation marks, at its end.
bool readStep(QString line, ShownSteps& steps)
{
    static const QRegularExpression said(QStringLiteral("\\s\"([^\"]+)\"$"));
    ShownStep step;
    if (const auto match = said.match(line); match.hasMatch()) {
        step.sentence = match.captured(1);
        line.truncate(match.capturedStart());
    }
    Words words = line.split(u' ', Qt::SkipEmptyParts);
    const QString first = words.isEmpty() ? QString() : words.takeFirst();
    if (first == QStringLiteral("ends"))
        return steps.ends.empty() && readEnds(words, steps.ends);
    const auto kind = std::ranges::find_if(
        kinds, [&](const KindInfo& info) { return latin(info.word) == first; });
    if (kind == kinds.end() || !steps.ends.empty())
        return false;
    step.kind = kind->kind;
    if (!kind->read(std::move(words), step))
        return false;
    steps.steps.push_back(std::move(step));
    return steps.steps.size() <= std::size_t(mostSteps);
}

} // namespace

bool ShownSteps::fitOn(const Point& page) const
{
    return std::ranges::all_of(steps, [&](const ShownStep& step) {
        return std::ranges::all_of(step.points, [&](const Point& p) {
            return p.x >= 0 && p.y >= 0 && p.x <= page.x && p.y <= page.y;
        });
    });
}

Result<ShownSteps> shownSteps(const QString& text)
{
    ShownSteps steps;
    bool hasPlace = false;
    const auto wrong = [](const QString& line) {
        return Result<ShownSteps>::failure(
            Text::tr("The steps of this page cannot be shown: \"%1\" is not understood.")
                .arg(line.left(80)));
    };
    for (const QString& each : text.split(u'\n')) {
        const QString line = each.simplified();
        if (line.isEmpty())
            continue;
        const bool isRead = hasPlace ? readStep(line, steps)
                                     : readPlace(line.split(u' ', Qt::SkipEmptyParts), steps);
        hasPlace = true;
        if (!isRead || line.size() > longestLine)
            return wrong(line);
    }
    if (steps.steps.empty() || steps.ends.empty())
        return Result<ShownSteps>::failure(
            Text::tr("The steps of this page cannot be shown: they are not complete."));
    return Result<ShownSteps>::of(std::move(steps));
}

bool ShownSteps::areIn(const Document& own) const
{
    return inCopy && !own.objects().empty() && own.objects().size() <= mostCopiedObjects
           && fitOn(millimetresOf(own.page()));
}

QString placeOfSteps(const QString& text, const Document& own)
{
    const auto steps = shownSteps(text);
    return !steps                          ? QString()
           : steps.value->areIn(own)       ? Text::tr("in a copy of the drawing")
           : steps.value->sample.isEmpty() ? Text::tr("in a new drawing")
                                           : Text::tr("in a sample drawing");
}

} // namespace app

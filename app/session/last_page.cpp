// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/last_page.h"

#include "app/base/number.h"
#include "app/base/text.h"
#include "app/document/document.h"
#include "app/document/paper.h"
#include "app/formats/svg/colour.h"
#include "app/session/page_steps.h"

#include <QStringList>

#include <algorithm>

namespace app {
namespace {

const QString scaleWord = QStringLiteral("scale="), unitWord = QStringLiteral("unit="),
              marginsWord = QStringLiteral("margins="), shownWord = QStringLiteral("shown"),
              backgroundWord = QStringLiteral("background="),
              exportedWord = QStringLiteral("exported");

Page ofPaper(const Point& millimetres)
{
    return {{0, 0}, millimetres, {millimetres.x, Unit::Mm}, {millimetres.y, Unit::Mm}};
}

/// Takes a word; false: it is none.
bool takeScale(Page& page, const QString& number)
{
    bool isNumber = false;
    auto scaled = withScale(page, number.toDouble(&isNumber));
    if (!isNumber || !scaled)
        return false;
    page = std::move(*scaled.value);
    return true;
}

bool takeUnit(Page& page, const QString& suffix)
{
    const auto row = std::ranges::find(units(), suffix.toStdString(), &UnitInfo::suffix);
    if (row == units().end() || !(row->millimetres > 0))
        return false;
    page.scale.unit = row->unit;
    return true;
}

bool takeMargins(Page& page, const QString& numbers)
{
    const QStringList sides = numbers.split(u',');
    PaperMargins margins = page.margins;
    double* const members[]{&margins.left, &margins.top, &margins.right, &margins.bottom};
    if (sides.size() != qsizetype(std::size(members)))
        return false;
    for (std::size_t i = 0; i < std::size(members); ++i) {
        bool isNumber = false;
        *members[i] = sides[qsizetype(i)].toDouble(&isNumber);
        if (!isNumber)
            return false;
    }
    auto with = withMargins(page, margins);
    if (with)
        page = std::move(*with.value);
    return bool(with);
}

bool takeBackground(Page& page, const QString& text)
{
    const auto colour = svg::parseColour(text.toStdString());
    if (colour)
        page.background.colour = *colour;
    return colour.has_value();
}

bool takeWord(Page& page, const QString& word)
{
    if (word.startsWith(scaleWord))
        return takeScale(page, word.sliced(scaleWord.size()));
    if (word.startsWith(unitWord))
        return takeUnit(page, word.sliced(unitWord.size()));
    if (word.startsWith(marginsWord))
        return takeMargins(page, word.sliced(marginsWord.size()));
    if (word.startsWith(backgroundWord))
        return takeBackground(page, word.sliced(backgroundWord.size()));
    page.margins.shown |= word == shownWord;
    page.background.exported |= word == exportedWord;
    return word == shownWord || word == exportedWord;
}

} // namespace

QString pageText(const Page& page)
{
    const Point paper = millimetresOf(page);
    const PaperMargins& margins = page.margins;
    QStringList words{shortestText(paper.x), shortestText(paper.y)};
    words << scaleWord + shortestText(page.scale.ratio);
    if (page.usualUnit() != Unit::Mm)
        words << unitWord + QLatin1StringView(infoOf(page.usualUnit()).suffix);
    QStringList sides;
    for (const double side : {margins.left, margins.top, margins.right, margins.bottom})
        sides << shortestText(side);
    words << marginsWord + sides.join(u',');
    if (margins.shown)
        words << shownWord;
    if (page.background.colour != PageBackground{}.colour)
        words << backgroundWord + QString::fromStdString(svg::hexOf(page.background.colour));
    if (page.background.exported)
        words << exportedWord;
    return words.join(u' ');
}

Page pageFromText(const QString& text)
{
    const Page usual = newDrawing().page();
    const QStringList words = text.left(300).split(u' ', Qt::SkipEmptyParts);
    if (words.size() < 2)
        return usual;
    const Point paper(words[0].toDouble(), words[1].toDouble());
    if (!withPaper(usual, paper))
        return usual;
    Page page = ofPaper(paper);
    const bool allTaken = std::all_of(words.begin() + 2, words.end(), [&page](const QString& word) {
        return takeWord(page, word);
    });
    return allTaken ? page : usual;
}

} // namespace app

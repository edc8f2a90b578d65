// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/pasted_text.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/document/document_builder.h"
#include "app/lettering/lettering.h"
#include "app/session/selection_style.h"

#include <glm/common.hpp>

namespace app {

namespace {

/// Lines end as in the program; a tab is four spaces, other control characters are left out.
QString plain(const QString& text)
{
    QString plain, from = text;
    from.replace(QStringLiteral("\r\n"), QStringLiteral("\n"));
    for (const QChar c : from)
        if (c == u'\n' || c == u'\r' || c == QChar::LineSeparator || c == QChar::ParagraphSeparator)
            plain += u'\n';
        else if (c == u'\t')
            plain += QStringLiteral("    ");
        else if (c.category() != QChar::Other_Control)
            plain += c;
    const auto isSpace = [](QStringView line) { return line.trimmed().isEmpty(); };
    QStringList lines = plain.split(u'\n');
    while (!lines.isEmpty() && isSpace(lines.front()))
        lines.removeFirst();
    while (!lines.isEmpty() && isSpace(lines.back()))
        lines.removeLast();
    return lines.join(u'\n');
}

Point centreOf(std::span<const Subpath> paths)
{
    Point min = paths.front().start, max = min;
    for (const Subpath& path : paths)
        forEachPoint(path, [&](const Point& p) {
            min = glm::min(min, p);
            max = glm::max(max, p);
        });
    return (min + max) * 0.5;
}

} // namespace

Result<Document> drawingOf(const Session& session, const PastedText& pasted)
{
    using Drawing = Result<Document>;
    const QString text = plain(pasted.text);
    if (text.size() > longestText)
        return Drawing::failure(
            Text::tr("The text on the clipboard has %1 characters, and a text at most %2. Copy "
                     "less.")
                .arg(countText(std::size_t(text.size())), countText(std::size_t(longestText))));
    const Page& page = session.now().page();
    TextRecipe recipe{text, pasted.font, pasted.millimetres / page.millimetresPerUnit(), {}};
    Lettering letters = lettered(recipe);
    if (letters.paths.empty())
        return Drawing::failure(Text::tr("The clipboard holds no text with letters to draw."));
    recipe.at = pasted.centre - centreOf(letters.paths);
    letters = lettered(recipe);
    DocumentBuilder builder;
    builder.open({});
    builder.add(Object{.path = Path(letters.paths),
                       .style = newStyle(session),
                       .particulars = {.recipe = recipe}});
    builder.close();
    return Drawing::of(builder.take(page));
}

} // namespace app

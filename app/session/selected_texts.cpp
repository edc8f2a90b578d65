// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/selected_texts.h"

#include "app/base/text.h"
#include "app/commands/change_paths.h"
#include "app/document/affine_map.h"
#include "app/lettering/lettering.h"
#include "app/lettering/outline_fonts.h"

#include <cmath>

namespace app {
namespace {

/// Calls visit(object, text) for each selected text.
template <class Visit>
void forEachText(const Session& session, const Visit& visit)
{
    for (const auto& [first, end] : session.selection().ranges())
        for (std::size_t object = first; object < end; ++object)
            visit(object, std::get<TextRecipe>(
                              Recipe(session.now().objects()[object].particulars().recipe)));
}

void push(Session& session, const std::vector<ChangedPath>& changed, const QString& undoText,
          Merging merging = Merging::Never)
{
    if (!changed.empty())
        session.history.push(new ChangePaths(session.document, changed, undoText, merging));
}

/// Lays out the letters again. A font that is not installed is replaced, and named.
template <class Change>
std::optional<QString> writeAgain(Session& session, const QString& undoText, const Change& change)
{
    if (selectedTexts(session).empty())
        return std::nullopt;
    std::vector<ChangedPath> changed;
    std::optional<QString> remark;
    forEachText(session, [&](std::size_t object, const TextRecipe& before) {
        TextRecipe text = before;
        change(text);
        if (!hasFont(text.font)) {
            remark = missingFontText(text.font);
            text.font = fontInsteadOf(text.font);
        }
        text.face = faceOf(text.font, text.face);
        if (text == before)
            return;
        const Lettering letters = lettered(text);
        if (letters.paths.empty())
            remark = Text::tr("A text is too long or too large for the font %1, and stays as it "
                              "is.")
                         .arg(text.font);
        else
            changed.push_back({object, Path(letters.paths), text});
        if (const QString missing = missingText(letters); !missing.isEmpty())
            remark = missing;
    });
    push(session, changed, undoText);
    return remark;
}

} // namespace

std::vector<TextRecipe> selectedTexts(const Session& session)
{
    std::vector<TextRecipe> texts;
    if (session.selection().size() > mostTextsAtOnce)
        return texts;
    for (const auto& [first, end] : session.selection().ranges())
        for (std::size_t object = first; object < end; ++object) {
            const Recipe recipe = session.now().objects()[object].particulars().recipe;
            const auto* text = std::get_if<TextRecipe>(&recipe);
            if (!text)
                return {};
            texts.push_back(*text);
        }
    return texts;
}

std::optional<QString> setTextFont(Session& session, const QString& font)
{
    return writeAgain(session, Text::tr("Font"), [&](TextRecipe& text) { text.font = font; });
}

std::optional<QString> setTextFace(Session& session, bool FontFace::*part, bool on)
{
    return writeAgain(session, part == &FontFace::bold ? Text::tr("Bold") : Text::tr("Italic"),
                      [&](TextRecipe& text) { text.face.*part = on; });
}

std::optional<QString> setTextSize(Session& session, double size, Merging merging)
{
    if (!(size > 0) || !std::isfinite(size))
        return Text::tr("The height of capital letters must be more than 0.");
    if (selectedTexts(session).empty())
        return std::nullopt;
    std::vector<ChangedPath> changed;
    forEachText(session, [&](std::size_t object, const TextRecipe& before) {
        const AffineMap map = scaling(Point(size / before.size), before.at);
        if (size == before.size || !map.isFinite())
            return;
        TextRecipe text = before;
        text.size = size;
        changed.push_back(
            {object, mapped(session.now().objects()[object].path(), map), std::move(text)});
    });
    push(session, changed, Text::tr("Text size"), merging);
    return std::nullopt;
}

} // namespace app

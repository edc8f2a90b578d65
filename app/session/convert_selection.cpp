// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/convert_selection.h"

#include "app/base/text.h"
#include "app/commands/change_paths.h"
#include "app/document/styles_in_use.h"
#include "app/session/session.h"

#include <algorithm>

namespace app {
namespace {

// Blocks of objects without particulars, the usual ones of large drawings, are skipped.
bool anyHasRecipe(const Objects& objects, const ObjectRange& range)
{
    for (std::size_t i = range.first; i < range.end;) {
        const std::size_t number = objects.blockOf(i);
        const ObjectBlock& block = *objects.blocks()[number];
        const std::size_t first = objects.firstOf(number);
        const std::size_t end = std::min(range.end, first + block.size());
        for (; i < end && !block.particulars.empty(); ++i)
            if (block.particulars[i - first]->recipe.index() != 0)
                return true;
        i = end;
    }
    return false;
}

std::vector<ChangedPath> withoutRecipes(const Session& session)
{
    std::vector<ChangedPath> changed;
    const Objects& objects = session.now().objects();
    for (const std::size_t object : session.selection())
        if (objects[object].particulars().recipe.index() != 0)
            changed.push_back({object, objects[object].path()});
    return changed;
}

} // namespace

QString convertRefusal(const Session& session)
{
    for (const ObjectRange& range : session.selection().ranges())
        if (anyHasRecipe(session.now().objects(), range))
            return {};
    return Text::tr("Select a text, rectangle, ellipse, polygon or star first.");
}

QString outlineRefusal(const Session& session)
{
    const Document& document = session.now();
    for (const StyleIndex index : stylesOf(document.objects(), session.selection()))
        if (const Style& style = document.styles()[index]; style.stroke && style.width > 0)
            return {};
    return Text::tr("Select an object with a stroke first.");
}

void convertToPaths(Session& session)
{
    const auto changed = withoutRecipes(session);
    if (!changed.empty())
        session.history.push(
            new ChangePaths(session.document, changed, Text::tr("Convert to path")));
}

} // namespace app

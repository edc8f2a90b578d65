// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/convert_selection.h"

#include "app/commands/change_paths.h"
#include "app/session/session.h"

#include <QCoreApplication>

namespace app {
namespace {

constexpr std::size_t most =
    10'000; // objects that are looked at after each change of the selection

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
    const Objects& objects = session.now().objects();
    if (session.selection().size() > most)
        return {};
    for (const std::size_t object : session.selection())
        if (objects[object].particulars().recipe.index() != 0)
            return {};
    return QCoreApplication::translate("Commands",
                                       "Select a text, rectangle, ellipse, polygon or star first.");
}

void convertToPaths(Session& session)
{
    const auto changed = withoutRecipes(session);
    if (!changed.empty())
        session.history.push(new ChangePaths(
            session.document, changed, QCoreApplication::translate("Commands", "Convert to path")));
}

} // namespace app

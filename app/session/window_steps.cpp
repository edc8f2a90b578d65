// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/window_steps.h"

#include "app/base/numbers.h"
#include "app/commands/add_objects.h"
#include "app/commands/set_windows.h"
#include "app/document/recipe_outline.h"
#include "app/document/window_outline.h"
#include "app/document/window_shape.h"
#include "app/session/selection_style.h"
#include "app/session/units.h"

#include <QCoreApplication>

#include <algorithm>

namespace app {
namespace {

QString tr(const char* text) { return QCoreApplication::translate("WindowSteps", text); }

void push(Session& session, ClipWindows windows, const QString& text,
          Merging merging = Merging::Never)
{
    if (windows != session.now().windows())
        session.history.push(new SetWindows(session.document, std::move(windows), text, merging));
}

// Upright rectangles keep their sides; other shapes become paths of the same form.
std::vector<Subpath> subpathsOf(const WindowShape& shape)
{
    if (const auto* path = std::get_if<PathShape>(&shape))
        return path->path.subpaths();
    const auto corners = cornersOf(std::get<RectangleShape>(shape));
    return {{corners[0], {{corners[1]}, {corners[2]}, {corners[3]}}, true}};
}

} // namespace

ClipWindows withShape(const Session& session, const WindowShape& shape)
{
    ClipWindows windows = session.now().windows();
    if (const auto number = session.windowNumber(); number && *number < windows.list.size())
        windows.list[*number].shape = shape;
    else
        windows.list.push_back({.shape = shape});
    return windows;
}

void setWindowShape(Session& session, const WindowShape& shape, const QString& text,
                    Merging merging)
{
    if (session.windowNumber())
        push(session, withShape(session, shape), text, merging);
    else
        addWindow(session, {.shape = shape});
}

void moveWindow(Session& session, const Point& by, Merging merging)
{
    if (const auto number = session.windowNumber())
        setWindowShape(session, mapped(session.windows().list[*number].shape, translation(by)),
                       tr("Move clip window"), merging);
}

ClipWindows withDrawn(const Session& session, const WindowShape& shape)
{
    if (!session.newWindow)
        return withShape(session, shape);
    ClipWindows windows = session.now().windows();
    windows.list.push_back({.shape = shape, .operation = *session.newWindow});
    return windows;
}

void drawWindow(Session& session, const WindowShape& shape)
{
    if (session.newWindow)
        addWindow(session, {.shape = shape, .operation = *session.newWindow});
    else
        setWindowShape(session, shape, tr("Draw clip window"));
}

bool addWindow(Session& session, ClipWindow window)
{
    ClipWindows windows = session.now().windows();
    const std::size_t number = windows.list.size();
    if (number == ClipWindows::most) {
        emit session.refused(
            tr("No clip window was drawn. This drawing has %1 clip windows, hidden "
               "ones included, and cannot take more. Delete a clip window first.")
                .arg(countText(ClipWindows::most)));
        return false;
    }
    windows.list.push_back(std::move(window));
    push(session, std::move(windows), tr("Draw clip window"));
    session.chooseWindow(number);
    return true;
}

void removeWindow(Session& session)
{
    const auto number = session.windowNumber();
    if (!number)
        return;
    ClipWindows windows = session.now().windows();
    windows.list.erase(windows.list.begin() + std::ptrdiff_t(*number));
    push(session, std::move(windows), tr("Remove clip window"));
    session.chooseWindow(*number > 0 ? *number - 1 : 0);
}

void reorderWindow(Session& session, std::size_t from, std::size_t to)
{
    ClipWindows windows = session.now().windows();
    auto& list = windows.list;
    if (from >= list.size() || to >= list.size() || from == to)
        return;
    const auto at = [&](std::size_t i) { return list.begin() + std::ptrdiff_t(i); };
    if (from < to)
        std::rotate(at(from), at(from + 1), at(to + 1));
    else
        std::rotate(at(to), at(from), at(from + 1));
    push(session, std::move(windows), tr("Reorder clip windows"));
    session.chooseWindow(to);
}

void changeWindow(Session& session, std::size_t number, const QString& text,
                  const std::function<void(ClipWindow&)>& change)
{
    ClipWindows windows = session.now().windows();
    if (number >= windows.list.size())
        return;
    change(windows.list[number]);
    push(session, std::move(windows), text);
}

std::optional<ClipWindow> windowOfSelection(const Session& session)
{
    const Objects& objects = session.now().objects();
    std::vector<Subpath> all;
    PathShape shape;
    QString name;
    for (const std::size_t number : session.selection()) {
        const ObjectView object = objects[number];
        if (!object.path().hasArea())
            continue;
        if (all.empty()) {
            shape.recipe = object.particulars().recipe;
            shape.rule = object.style().fillRule;
            name = object.particulars().id;
        }
        for (Subpath& path : object.path().subpaths())
            all.push_back(std::move(path));
    }
    if (all.empty())
        return std::nullopt;
    if (!makes(shape.recipe, all))
        shape.recipe = {};
    const auto* rectangle = std::get_if<RectangleRecipe>(&shape.recipe);
    if (rectangle && rectangle->radius == 0)
        return ClipWindow{name,
                          RectangleShape{{rectangle->corner, rectangle->corner + rectangle->size}}};
    shape.path = Path(all);
    return ClipWindow{name, std::move(shape)};
}

void windowToPath(Session& session)
{
    const auto number = session.windowNumber();
    if (!number)
        return;
    const ClipWindow& window = session.windows().list[*number];
    Object object{Path(subpathsOf(window.shape)), newStyle(session)};
    if (const auto* path = std::get_if<PathShape>(&window.shape)) {
        object.particulars.recipe = path->recipe;
        object.style.fillRule = path->rule;
    }
    const std::size_t before = session.now().objects().size();
    Objects objects = session.now().objects().slice(0, 0);
    objects.append(object);
    session.history.push(new AddObjects(session.document, objects, containerForNew(session),
                                        tr("Draw clip window's outline")));
    if (session.now().objects().size() == before + 1)
        session.select(ObjectRanges(ObjectRange{before, before + 1}));
}

} // namespace app

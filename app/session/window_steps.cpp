// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/window_steps.h"

#include "app/base/numbers.h"
#include "app/base/text.h"
#include "app/commands/add_and_remove.h"
#include "app/commands/set_page_parts.h"
#include "app/document/window_operations.h"
#include "app/document/window_shape.h"
#include "app/session/arrange_selection.h"
#include "app/session/selection_style.h"
#include "app/session/units.h"
#include "app/session/window_words.h"

#include <algorithm>

namespace app {
namespace {

void pushWindows(Session& session, ClipWindows windows, const QString& text,
                 Merging merging = Merging::Never)
{
    if (windows != session.now().windows())
        session.history.push(new SetWindows(session.document, std::move(windows), text, merging));
}

} // namespace

// A preview may have a window more than the document.
static std::optional<std::size_t> numberIn(const ClipWindows& windows, const Session& session)
{
    const auto number = session.windowNumber();
    return number && *number < windows.list.size() ? number : std::nullopt;
}

static ClipWindow reshaped(ClipWindow window, const WindowShape& shape)
{
    window.name = nameAfter(window, shape);
    window.shape = shape;
    return window;
}

ClipWindows withShape(const Session& session, const WindowShape& shape)
{
    ClipWindows windows = session.now().windows();
    if (const auto number = numberIn(windows, session))
        windows.list[*number] = reshaped(windows.list[*number], shape);
    else
        windows.list.push_back(
            {.name = numberedName(shape, numberForNew(windows)), .shape = shape});
    return windows;
}

void setWindowShape(Session& session, const WindowShape& shape, const QString& text,
                    Merging merging)
{
    if (numberIn(session.now().windows(), session))
        pushWindows(session, withShape(session, shape), text, merging);
    else
        addWindows(session, {{.shape = shape}}, text);
}

void setNextWindow(Session& session, std::string_view kind)
{
    session.nextWindow = kind;
    emit session.displayChanged(); // bars and tools show it
}

// While it is drawn, the drawn window is in the preview.
DrawnWindow withDrawn(const Session& session, const WindowShape& shape)
{
    ClipWindows windows = session.now().windows();
    const std::size_t number = windows.list.size();
    windows.list.push_back({.name = numberedName(shape, numberForNew(windows)), .shape = shape});
    return {std::move(windows), number};
}

void drawWindow(Session& session, const WindowShape& shape)
{
    addWindow(session, {.shape = shape});
}

bool chooseNeighbour(Session& session, int step)
{
    const auto& list = session.windows().list;
    const auto chosen = session.windowNumber();
    if (!chosen)
        return false;
    const std::size_t by = step > 0 ? 1 : list.size() - 1;
    std::size_t next = (*chosen + by) % list.size();
    while (next != *chosen && !list[next].visible)
        next = (next + by) % list.size();
    if (next == *chosen)
        return false;
    session.chooseWindow(next);
    return true;
}

void moveWindow(Session& session, const Point& by, Merging merging)
{
    if (const auto number = session.windowNumber())
        setWindowShape(session, mapped(session.windows().list[*number].shape, translation(by)),
                       Text::tr("Move clip window"), merging);
}

bool addWindows(Session& session, std::vector<ClipWindow> added, const QString& text)
{
    ClipWindows windows = session.now().windows();
    auto& list = windows.list;
    if (list.size() + added.size() > ClipWindows::most) {
        emit session.refused(
            Text::tr("No clip window was drawn. This drawing has %1 clip windows, hidden "
                     "ones included, and cannot have more than %2. Delete a clip window "
                     "first.")
                .arg(countText(list.size()), countText(ClipWindows::most)));
        return false;
    }
    int number = numberForNew(windows);
    for (ClipWindow& window : added) {
        if (window.name.isEmpty())
            window.name = numberedName(window.shape, number);
        ++number;
        list.push_back(std::move(window));
    }
    const std::size_t last = list.size() - 1;
    pushWindows(session, std::move(windows), text);
    session.chooseWindow(last);
    return true;
}

bool addWindow(Session& session, ClipWindow window)
{
    return addWindows(session, {std::move(window)}, Text::tr("Draw clip window"));
}

void removeWindow(Session& session)
{
    ClipWindows windows = session.now().windows();
    const auto number = numberIn(windows, session);
    if (!number)
        return;
    windows.list.erase(windows.list.begin() + std::ptrdiff_t(*number));
    pushWindows(session, std::move(windows), Text::tr("Remove clip window"));
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
    pushWindows(session, std::move(windows), Text::tr("Reorder clip windows"));
    session.chooseWindow(to);
}

void changeWindow(Session& session, std::size_t number, const QString& text,
                  const std::function<void(ClipWindow&)>& change)
{
    ClipWindows windows = session.now().windows();
    if (number >= windows.list.size())
        return;
    change(windows.list[number]);
    pushWindows(session, std::move(windows), text);
}

void setWindowOperation(Session& session, std::size_t number, WindowOperation operation)
{
    const auto& list = session.now().windows().list;
    if (number >= list.size() || list[number].operation == operation)
        return;
    if (const QString why = whyNot(session.now().windows(), number, operation); !why.isEmpty()) {
        emit session.refused(why);
        return;
    }
    changeWindow(session, number, infoOf(operation).step.arg(nameOf(list[number])),
                 [operation](ClipWindow& window) { window.operation = operation; });
}

std::vector<ClipWindow> windowsOfSelection(const Session& session)
{
    std::vector<ClipWindow> windows;
    for (const std::size_t number : session.selection())
        if (auto window = windowOf(session.now().objects()[number])) {
            windows.push_back(std::move(*window));
            if (windows.size() > ClipWindows::most)
                break; // too many in any case
        }
    return windows;
}

void addWindowsOfSelection(Session& session)
{
    auto made = windowsOfSelection(session);
    const std::size_t all = session.selection().size(), count = made.size();
    if (made.empty()) {
        emit session.refused(
            Text::tr("None of the selected objects encloses an area, so they cannot be "
                     "clip windows. Select a closed shape."));
        return;
    }
    if (!addWindows(session, std::move(made), Text::tr("Make clip windows of selection"))
        || count == all)
        return;
    emit session.refused(
        all - count == 1
            ? Text::tr("1 of the %1 selected objects encloses no area and was left out.")
                  .arg(countText(all))
            : Text::tr("%1 of the %2 selected objects enclose no area and were left out.")
                  .arg(countText(all - count), countText(all)));
}

void windowToPath(Session& session)
{
    const auto number = session.windowNumber();
    if (!number)
        return;
    if (!mayAddObjects(session)) {
        emit session.refused(
            Text::tr("The layer %1 is locked or hidden, so nothing was drawn. Select "
                     "another layer, or unlock and show this one.")
                .arg(nameForNew(session)));
        return;
    }
    PathShape shape = pathOf(session.windows().list[*number].shape);
    Object object{shape.path, newStyle(session)};
    object.particulars.recipe = shape.recipe;
    object.style.fillRule = shape.rule;
    Objects objects = session.now().objects().slice(0, 0);
    objects.append(object);
    session.history.push(new AddObjects(session.document, objects, containerForNew(session),
                                        Text::tr("Draw clip window's outline")));
    session.select(justAdded(session));
}

} // namespace app

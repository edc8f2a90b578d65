// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/window_words.h"

#include "app/base/text.h"
#include "app/comparison/differences_at.h"
#include "app/document/window_operations.h"
#include "app/session/units.h"

#include <QCoreApplication>

#include <algorithm>

namespace app {
namespace {

/// A kind of shape, in words and as an icon.
struct Looks {
    const char* name;
    std::string_view icon;
};

constexpr Looks rectangleLooks{QT_TRANSLATE_NOOP("Text", "Rectangle"), "rectangle"};

Looks looksOf(const Recipe& recipe)
{
    if (std::holds_alternative<RectangleRecipe>(recipe))
        return rectangleLooks;
    if (std::holds_alternative<EllipseRecipe>(recipe))
        return {QT_TRANSLATE_NOOP("Text", "Ellipse"), "ellipse"};
    if (std::holds_alternative<TextRecipe>(recipe))
        return {QT_TRANSLATE_NOOP("Text", "Text"), "text"};
    if (const auto* star = std::get_if<StarRecipe>(&recipe); star && star->inner > 0)
        return {QT_TRANSLATE_NOOP("Text", "Star"), "star"};
    if (std::holds_alternative<StarRecipe>(recipe))
        return {QT_TRANSLATE_NOOP("Text", "Polygon"), "polygon"};
    return {QT_TRANSLATE_NOOP("Text", "Path"), "pen"};
}

Looks looksOf(const WindowShape& shape)
{
    const auto* path = std::get_if<PathShape>(&shape);
    return path ? looksOf(path->recipe) : rectangleLooks;
}

} // namespace

QString nameOf(const WindowShape& shape) { return Text::tr(looksOf(shape).name); }

QString numberedName(const WindowShape& shape, int number)
{
    return Text::tr("%1 %2").arg(nameOf(shape)).arg(number);
}

/// The number of a name that was made of the window's shape; 0: a person gave it.
static int numberOf(const ClipWindow& window)
{
    constexpr int most = 1'000'000; // a person's
    const int number = window.name.section(u' ', -1).toInt();
    return number > 0 && number < most && window.name == numberedName(window.shape, number) ? number
                                                                                            : 0;
}

int numberForNew(const ClipWindows& others)
{
    int last = int(others.list.size());
    for (const ClipWindow& window : others.list)
        last = std::max(last, numberOf(window));
    return last + 1;
}

QString nameAfter(const ClipWindow& before, const WindowShape& shape)
{
    const int number = numberOf(before);
    return number > 0 ? numberedName(shape, number) : before.name;
}

QString nameOf(const ObjectView& object)
{
    const Particulars& particulars = object.particulars();
    const QString kind =
        object.singleLine() ? Text::tr("Line") : Text::tr(looksOf(particulars.recipe).name);
    return particulars.id.isEmpty() ? kind : Text::tr("%1 “%2”").arg(kind, particulars.id);
}

QString nameOf(const ClipWindow& window)
{
    return window.name.isEmpty() ? nameOf(window.shape) : window.name;
}

std::string_view iconOf(const WindowShape& shape) { return looksOf(shape).icon; }

std::string_view iconOf(const ObjectView& object)
{
    return object.singleLine() ? "line" : looksOf(object.particulars().recipe).icon;
}

QString resultOf(const ClipWindows& windows)
{
    QString text;
    const ClipWindows counting = inEffect(windows);
    const auto end = counting.list.end();
    for (auto window = counting.list.begin(); window != end;) {
        const QString name = nameOf(*window);
        const WindowOperation operation = window->operation;
        const auto next = std::find_if(window, end, [&](const ClipWindow& other) {
            return other.operation != operation || nameOf(other) != name;
        });
        if (text.isEmpty() && operation != WindowOperation::Add)
            text = Text::tr("everything");
        if (!text.isEmpty())
            text += u' ' + infoOf(operation).sign + u' ';
        const auto count = next - window; // of neighbours that read the same
        text += count == 1 ? name : Text::tr("%1 × %2").arg(count).arg(name);
        window = next;
    }
    return text;
}

QString replacedText(const ClipWindows& windows, std::size_t number)
{
    const auto other = replacing(windows, number);
    return other ? Text::tr("without effect: %1 replaces it").arg(nameOf(windows.list[*other]))
                 : QString();
}

QString whyNot(const ClipWindows& windows, std::size_t number, WindowOperation operation)
{
    const ClipWindow& window = windows.list[number];
    return number > 0 || !infoOf(operation).needsOneAbove || window.operation == operation
               ? QString()
               : Text::tr("No clip window is above %1.").arg(nameOf(window));
}

QString comparedName(const Session& session)
{
    const auto number = session.compared().number;
    const bool alone = session.region().steps.size() == 1 && session.region().keep == Keep::Inside
                       && session.region().single();
    return number && !alone ? nameOf(session.windows().list[*number]) : QString();
}

QString chosenText(const Session& session, bool forWindow)
{
    const auto number = session.windowNumber();
    if (forWindow && number)
        return Text::tr("%1, clip window").arg(nameOf(session.windows().list[*number]));
    const QString text = selectionText(session);
    return session.selection().empty() ? text : Text::tr("%1, selected").arg(text);
}

QString comparedText(const Session& session)
{
    if (!session.compared().comparable)
        return Text::tr(
            "Nothing is compared: no clip window is a rectangle along the axes. Draw one to "
            "compare there.");
    const QString name = comparedName(session);
    return name.isEmpty() ? atText(session.compared())
                          : Text::tr("Compared inside %1 only.").arg(name);
}

} // namespace app

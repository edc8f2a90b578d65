// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editing.h"

#include "app/commands/add_shapes.h"
#include "app/commands/move_shapes.h"
#include "app/commands/remove_shapes.h"
#include "app/document/clipboard.h"
#include "app/document/copy_place.h"
#include "app/document/editable.h"

#include <QClipboard>
#include <QCoreApplication>
#include <QGuiApplication>
#include <QMimeData>

#include <map>

namespace ui {

namespace {

constexpr double stepMillimetres = 5; // of a copy from what it is a copy of, and from the last

QString tr(const char* text) { return QCoreApplication::translate("Editing", text); }

/// One command for each layer, in one undo step; then they are what is selected.
void add(app::Session& session, std::vector<app::Shape> shapes, const QString& text)
{
    std::map<std::uint32_t, std::vector<app::Shape>> byLayer;
    const app::Point step(stepMillimetres / session.sheet().page.millimetresPerUnit());
    const app::Point offset = app::copyOffset(session.sheet(), shapes, step);
    for (app::Shape& shape : shapes) {
        auto& layer = byLayer[shape.layer];
        layer.push_back(app::moved(std::move(shape), offset));
    }
    session.history.beginMacro(text);
    app::ObjectRanges added;
    for (auto& [layer, some] : byLayer) { // from the lowest: later ones do not move earlier ones
        auto* command = new app::AddShapes(session.drawing, std::move(some), text);
        session.history.push(command);
        added = united(added, command->shapes());
    }
    session.history.endMacro();
    session.select(std::move(added));
}

std::vector<app::Shape> selected(const app::Session& session)
{
    std::vector<app::Shape> shapes;
    shapes.reserve(session.selection().size());
    for (const std::size_t shape : session.selection())
        shapes.push_back(session.sheet().shapes[shape]);
    return shapes;
}

} // namespace

void copySelection(const app::Session& session)
{
    if (!session.selection().empty())
        QGuiApplication::clipboard()->setMimeData(
            app::copied(session.sheet(), session.selection()).release()); // the clipboard owns it
}

void cutSelection(app::Session& session)
{
    if (session.selection().empty())
        return;
    copySelection(session);
    session.history.push(new app::RemoveShapes(session.drawing, session.selection(), tr("Cut")));
    session.select({});
}

QString nothingToPaste() { return tr("The clipboard holds no drawing. Copy lines first."); }

bool paste(app::Session& session)
{
    const QMimeData* data = QGuiApplication::clipboard()->mimeData();
    auto shapes = data ? app::pasted(*data, session.sheet().page, session.pen.layer)
                       : std::vector<app::Shape>();
    if (shapes.empty())
        return false;
    add(session, std::move(shapes), tr("Paste"));
    return true;
}

void duplicateSelection(app::Session& session)
{
    if (!session.selection().empty())
        add(session, selected(session), tr("Duplicate"));
}

void deleteSelection(app::Session& session)
{
    if (session.selection().empty())
        return;
    session.history.push(new app::RemoveShapes(session.drawing, session.selection()));
    session.select({});
}

void selectAll(app::Session& session) { session.select(app::editableObjects(session.sheet())); }

} // namespace ui

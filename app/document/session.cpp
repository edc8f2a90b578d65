// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/document/session.h"

#include "app/document/bounds.h"
#include "app/document/usual_algorithm.h"
#include "app/formats/unfinished.h"

#include <algorithm>

namespace app {

Session::Session(QObject* parent) : QObject(parent)
{
    display_.algorithm = &usualAlgorithm();
    connect(&drawing, &Drawing::changed, this, &Session::follow);
    connect(&scene, &Scene::outdated, this, [this] {
        if (inspected_ && *inspected_ >= scene.segments().size())
            inspect(std::nullopt);
    });
    connect(this, &Session::previewChanged, this, [this] {
        differences.setWindow(window());
        truth.setWindow(window());
    });
}

void Session::setDisplay(const Display& display)
{
    if (display == display_)
        return;
    display_ = display;
    emit displayChanged();
}

const clipping::Uses<clipping::Segment, clipping::Window>& Session::uses() const
{
    return *clipping::usesOf(*display_.algorithm, display_.usedForm());
}

void Session::select(ObjectRanges objects)
{
    if (objects == selection_)
        return;
    selection_ = std::move(objects);
    selectionBounds_.reset();
    emit selectionChanged();
}

const std::optional<clipping::Window>& Session::selectionBounds() const
{
    if (!selectionBounds_)
        selectionBounds_.emplace(boundsOf(scene, selection_));
    return *selectionBounds_;
}

void Session::inspect(std::optional<std::size_t> segment)
{
    if (segment == inspected_)
        return;
    inspected_ = segment;
    emit inspectedChanged();
}

void Session::setPreview(const Preview& preview)
{
    if (preview == preview_)
        return;
    preview_ = preview;
    emit previewChanged();
}

void Session::load(Imported imported, const QString& path)
{
    losses_ = std::move(imported.report);
    path_ = path;
    history.clear();
    pen.layer = std::uint32_t(imported.sheet.layers.size() - 1);
    drawing.load(std::move(imported.sheet));
    Display display = display_;
    display.unit = sheet().page.usualUnit();
    setDisplay(display);
    emit fileChanged();
    emit loaded();
}

bool Session::mustSaveAs() const
{
    return path_.isEmpty()
           || std::ranges::any_of(losses_, [](const Loss& loss) { return !loss.remark; });
}

std::optional<QString> Session::save(const QString& path)
{
    {
        const Unfinished guard(path);
        if (auto error = writeFile(sheet(), path))
            return error;
    }
    path_ = path;
    losses_.clear();
    history.setClean();
    emit fileChanged();
    return std::nullopt;
}

void Session::follow(const Change& change)
{
    if (change.kind != Change::Kind::Window)
        selectionBounds_.reset();
    if (change.kind == Change::Kind::Everything)
        select({}), preview_ = {};
    if (change.kind == Change::Kind::Shapes && change.removed != change.added)
        select(selection_.shifted(change.first, change.removed, change.added));
    if (change.kind != Change::Kind::Window)
        inspect(std::nullopt);
    pen.layer = std::min(pen.layer, std::uint32_t(sheet().layers.size() - 1));
    if (change.kind == Change::Kind::Window || change.kind == Change::Kind::Everything)
        emit previewChanged();
}

} // namespace app

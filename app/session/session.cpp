// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/session.h"

#include "app/base/variant.h"
#include "app/commands/set_style.h"
#include "app/document/object_ranges.h"
#include "app/document/window_shape.h"
#include "app/scene/bounds.h"
#include "app/session/selection_memory.h"

#include <algorithm>
#include <utility>

namespace app {

/// The topmost layer that can be drawn on; the topmost of all if there is none.
static ContainerId layerForNew(const Containers& containers)
{
    const auto layers = containers.childrenOf(0);
    for (auto layer = layers.rbegin(); layer != layers.rend(); ++layer)
        if (containers.shown(*layer) && !containers.locked(*layer))
            return *layer;
    return layers.back();
}

/// The selected objects that a change has hidden.
static ObjectRanges hiddenAmong(const Objects& all, const ObjectRanges& selection,
                                std::span<const Splice> splices)
{
    ObjectRanges hidden;
    const ObjectRanges changed = common(selection, addedBy(splices));
    for (const ObjectRange& range : changed.ranges())
        all.forEach(range.first, range.size(), [&](std::size_t i, const ObjectView& object) {
            if (object.hidden())
                hidden.insert(i);
        });
    return hidden;
}

Session::Session(QObject* parent) : QObject(parent)
{
    display_.variant.algorithm = &usualAlgorithm();
    pen.layer = layerForNew(now().containers());
    updateWindows();
    followPage(true);
    new SelectionMemory(*this); // before say(), which signals the selection that it remembers
    connect(&document, &EditedDocument::changed, this, &Session::say);
    connect(&scene, &Scene::outdated, this, [this] {
        if (inspected_ && *inspected_ >= scene.lines().size())
            inspect(std::nullopt);
    });
    connect(this, &Session::previewChanged, this, [this] {
        differences.setWindow(comparedAt());
        exactness.setWindow(comparedAt());
    });
}

void Session::updateWindows()
{
    windows_ = preview_.windows.value_or(now().windows());
    region_ = shownRegionOf(windows_, now().page());
    updateChoice();
}

void Session::updateChoice()
{
    windowNumber_ = actedOn(windows_, chosenWindow_);
    clipWindow_.reset();
    windowFrame_.reset();
    if (windowNumber_ && !isEmpty(windows_.list[*windowNumber_].shape)) {
        windowFrame_ = frameOf(windows_.list[*windowNumber_].shape);
        clipWindow_ = boxOf(*windowFrame_);
    }
    compared_ = comparedWindow(windows_, now().page(), windowNumber_);
}

void Session::chooseWindow(std::size_t number)
{
    const bool wasLast = std::exchange(chosenLast_, true);
    if (std::exchange(chosenWindow_, number) == number) {
        if (!wasLast)
            emit selectionChanged(); // keys are for the window now
        return;
    }
    updateChoice();
    emit previewChanged();
}

void Session::setDisplay(const Display& display)
{
    if (display == display_)
        return;
    display_ = display;
    emit displayChanged();
}

const clipping::Functions<clipping::Segment, clipping::Window>& Session::uses() const
{
    const Variant used = cuts();
    return *clipping::functionsOf(*used.algorithm, used.form);
}

void Session::select(ObjectRanges objects)
{
    const bool windowWasLast = std::exchange(chosenLast_, false);
    if (objects == selection_) {
        if (windowWasLast)
            emit selectionChanged(); // keys are for the objects now, or for none
        return;
    }
    selection_ = std::move(objects);
    selectionBounds_.reset();
    guide.reset(); // keys are for the objects now
    emit selectionChanged();
}

const std::optional<clipping::Window>& Session::selectionBounds() const
{
    if (!selectionBounds_)
        selectionBounds_.emplace(boundsOf(scene.lines(), selection_));
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
    const bool sameWindows = preview.windows == preview_.windows;
    preview_ = preview;
    if (!sameWindows)
        updateWindows();
    emit previewChanged();
}

void Session::load(Imported imported, const QString& path, std::optional<SceneBlockCache> blocks)
{
    losses_.clear(); // what an empty document has, if the new one does not fit into memory
    path_.clear();
    saving_ = false;
    history.clear();
    if (blocks)
        scene.expect(std::move(*blocks));
    const PageMeasure before = pageMeasure_;
    document.load(std::move(imported.document));
    losses_ = std::move(imported.report);
    path_ = path;
    changeDisplay([this](Display& display) { display.unit = now().page().usualUnit(); });
    if (pageMeasure_ != before)
        emit displayChanged(); // the same lengths are other numbers
    emit fileChanged();
    microscope.close(); // its line was of the drawing before
    emit loaded();
}

bool Session::mustSaveAs() const { return path_.isEmpty() || app::mustSaveAs(losses_); }

Document Session::beginSaving()
{
    saving_ = true;
    history.beginClean();
    return now();
}

void Session::endSaving(const QString& path)
{
    if (!std::exchange(saving_, false))
        return;
    path_ = path;
    losses_.clear();
    history.endClean();
    emit fileChanged();
}

// All other signals are emitted after the scene has followed the change.
void Session::follow(const DocumentChange& change)
{
    std::optional<Chosen> before = std::exchange(chosenBefore_, std::nullopt);
    if (!change.again) {
        before = chosenAfter(change);
        selectionFollowed_ = selectionFollowed_ || before->selection != selection_;
        exchange(*before);
        chosenBefore_ = std::move(before);
    } else if (before) {
        selectionFollowed_ = true;
        exchange(*before);
    }
    if (change.everything) {
        preview_ = {};
        const ClipWindows& loaded = now().windows();
        chosenWindow_ = actedOn(loaded, loaded.list.size()).value_or(0);
    }
    if (change.drawing())
        selectionBounds_.reset();
    if (change.windows || change.page)
        updateWindows();
}

Session::Chosen Session::chosenAfter(const DocumentChange& change) const
{
    const Containers& containers = now().containers();
    Chosen next{change.everything ? ObjectRanges() : followed(selection_, change.splices),
                pen.layer, guide};
    if (change.everything || !containers.contains(pen.layer))
        next.layer = layerForNew(containers);
    if (change.everything || change.page)
        next.guide.reset(); // it may have another number, or be gone
    if (change.containers)  // also by undo: hidden or locked objects cannot be edited
        next.selection =
            without(next.selection, united(containers.hiddenRanges(), containers.lockedRanges()));
    next.selection =
        without(next.selection, hiddenAmong(now().objects(), next.selection, change.splices));
    return next;
}

void Session::exchange(Chosen& other) noexcept
{
    std::swap(other.selection, selection_);
    std::swap(other.layer, pen.layer);
    std::swap(other.guide, guide);
}

/// A page of another scale has another unit, and its strokes are as wide on paper as before.
void Session::followPage(bool isOther)
{
    const Page& page = now().page();
    const PageMeasure measure{page.millimetresPerUnit(), page.realMillimetresPerUnit(),
                              page.usualUnit()};
    const PageMeasure before = std::exchange(pageMeasure_, measure);
    if (isOther || measure == before)
        return;
    if (measure.onPaper != before.onPaper)
        scaleStroke(pen.style, before.onPaper / measure.onPaper);
    if (measure.unit != before.unit && display_.unit != measure.unit)
        display_.unit = measure.unit;
    emit displayChanged(); // fields, bars and rulers show it
}

void Session::say(const DocumentChange& change)
{
    if (std::exchange(selectionFollowed_, false))
        emit selectionChanged();
    if (change.drawing())
        inspect(std::nullopt);
    if (change.page)
        followPage(change.everything);
    if (change.windows || change.page) // without a clip window, algorithms are compared at the page
        emit previewChanged();
}

} // namespace app

#include "moc_session.cpp"

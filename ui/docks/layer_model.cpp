// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/layer_model.h"

#include "app/commands/set_containers.h"
#include "app/commands/set_hidden.h"
#include "app/document/kept_rows.h"
#include "app/session/layer_steps.h"
#include "app/session/name_object.h"
#include "app/session/units.h"
#include "ui/look/text.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace ui {

using Kind = app::TreeRow::Kind;

LayerModel::LayerModel(app::Session& session, QObject* parent)
    : CheckedModel(parent), session_(session), rows_(tree_.rows(session.now().containers()))
{
    connect(&session.document, &app::EditedDocument::changed, this, &LayerModel::follow);
    connect(&session, &app::Session::selectionChanged, this, [this] {
        tellChanged({SelectedRole, HoldsRole});
    });
    searching_.setInterval(0);
    connect(&searching_, &QTimer::timeout, this, &LayerModel::searchOn);
}

int LayerModel::rows() const { return int(rows_.size()); }

const app::TreeRow* LayerModel::rowAt(const QModelIndex& index) const
{
    return isCell(index) ? &rows_[std::size_t(index.row())] : nullptr;
}

app::ContainerId LayerModel::layerOf(const QModelIndex& index) const
{
    const app::TreeRow* row = rowAt(index);
    return row && row->kind == Kind::Layer ? row->container : 0;
}

app::ContainerId LayerModel::layerAround(const QModelIndex& index) const
{
    const app::Containers& containers = session_.now().containers();
    const app::TreeRow* row = rowAt(index);
    app::ContainerId id = row ? row->container : 0;
    while (id != 0 && containers.contains(id) && containers[id].kind != app::Container::Kind::Layer)
        id = containers.parentOf(id);
    return id;
}

QModelIndex LayerModel::indexOf(app::ContainerId layerOrGroup) const
{
    const auto found = std::ranges::find_if(rows_, [&](const app::TreeRow& row) {
        return row.container == layerOrGroup
               && (row.kind == Kind::Layer || row.kind == Kind::Group);
    });
    return index(int(found - rows_.begin()));
}

LayerModel::RowKey LayerModel::keyOf(const app::TreeRow& row) const
{
    const bool isObject = row.kind == Kind::Object;
    if (isObject && row.number >= session_.now().objects().size())
        return {Kind::More, 0}; // the document has changed; follow() will be called
    return {row.kind, isObject ? session_.document.numbers().of(row.number) : row.container};
}

QModelIndex LayerModel::indexOf(const RowKey& key) const
{
    const auto found =
        std::ranges::find(rows_, key, [this](const app::TreeRow& row) { return keyOf(row); });
    return index(int(found - rows_.begin()));
}

app::ObjectRanges LayerModel::objectsOf(int first, int last) const
{
    app::ObjectRanges objects;
    for (int number = std::max(first, 0); number <= last && number < rows(); ++number) {
        const app::TreeRow& row = rows_[std::size_t(number)];
        if (row.kind == Kind::Object)
            objects.insert(row.number);
        else if (row.kind == Kind::Group)
            objects.insert(session_.now().containers().rangeOf(row.container));
    }
    return objects.empty() ? objects : common(objects, app::selectableObjects(session_));
}

void LayerModel::setOpen(const QModelIndex& index, bool open)
{
    const app::TreeRow* row = rowAt(index);
    if (!row || !index.data(OpenRole).isValid()) // what is found is shown, be it open or not
        return;
    tree_.setOpen(row->container, open);
    showRows();
    tellChanged({OpenRole});
}

void LayerModel::find(const QString& typed)
{
    if (typed.simplified() == typed_)
        return;
    typed_ = typed.simplified();
    most_ = app::ObjectTree::atFirst;
    showsOld_ = false;
    searchAgain();
    tellChanged({OpenRole});
}

// A first slice at once, so that a drawing of usual size shows no half of what is found.
void LayerModel::searchAgain()
{
    search_.reset();
    searching_.stop();
    isOutdated_ = false;
    if (typed_.isEmpty()) {
        showRows();
        emit foundChanged();
        return;
    }
    search_.emplace(session_, typed_);
    searched_ = session_.document.revision();
    searching_.start();
    searchOn();
}

void LayerModel::searchOn()
{
    constexpr std::chrono::milliseconds atOnce(6);
    const std::size_t before = search_->found();
    if (search_->advance(atOnce))
        searching_.stop();
    if (showsOld_ && searching_.isActive() && search_->found() < most_)
        return;
    const bool showsOld = std::exchange(showsOld_, false);
    // While it goes on, no row is inserted into those that are seen.
    if (before < most_ || showsOld || !searching_.isActive())
        showRows();
    emit foundChanged();
}

void LayerModel::setSeen(bool seen)
{
    isSeen_ = seen;
    if (isSeen_ && isOutdated_)
        searchAgain();
}

QModelIndex LayerModel::firstFound() const
{
    const auto found = std::ranges::find_if(rows_, [](const app::TreeRow& row) {
        return row.kind == Kind::Object || row.kind == Kind::Group;
    });
    return index(found == rows_.end() ? 0 : int(found - rows_.begin()));
}

void LayerModel::showMore(const QModelIndex& index)
{
    if (const app::TreeRow* row = rowAt(index); row && row->kind == Kind::More) {
        most_ += app::ObjectTree::atFirst;
        if (!search_)
            tree_.showMore(row->container);
        showRows();
    }
}

QModelIndex LayerModel::revealSelection()
{
    const app::Containers& containers = session_.now().containers();
    const app::ObjectRanges& selection = session_.selection();
    const app::ContainerId group =
        selection.empty() ? 0 : app::groupAt(session_, selection.first());
    const bool isGroup = group != 0 && selection == app::ObjectRanges(containers.rangeOf(group));
    const bool changed = isGroup                 ? tree_.revealGroup(containers, group)
                         : selection.size() == 1 ? tree_.revealObject(containers, selection.first())
                                                 : selection.empty() && tree_.conceal();
    if (changed) {
        showRows();
        tellChanged({OpenRole});
    }
    if (!isGroup && selection.size() != 1)
        return {};
    const auto found = std::ranges::find_if(rows_, [&](const app::TreeRow& row) {
        return isGroup ? row.kind == Kind::Group && row.container == group
                       : row.kind == Kind::Object && row.number == selection.first();
    });
    if (found != rows_.end())
        return index(int(found - rows_.begin()));
    app::ContainerId around = containers.containerOf(selection.first());
    while (around != 0 && !indexOf(around).isValid())
        around = containers.parentOf(around);
    return indexOf(around);
}

std::vector<app::TreeRow> LayerModel::rowsNow() const
{
    if (!search_)
        return tree_.rows(session_.now().containers());
    // The selection may change before follow() is called.
    if (isOutdated_ || showsOld_ || searched_ != session_.document.revision())
        return rows_;
    auto rows = search_->rows(most_);
    if (search_->found() > most_)
        rows.push_back({Kind::More, rows.back().container, search_->found() - most_, 1});
    return rows;
}

/// Rows at the beginning and at the end that stay the same keep what views know of them.
void LayerModel::showRows()
{
    auto now = rowsNow();
    if (now == rows_)
        return;
    changesRows_ = true;
    const auto [before, after] = std::ranges::mismatch(rows_, now);
    const auto first = before - rows_.begin();
    std::ptrdiff_t same = 0;
    const auto shorter = std::ptrdiff_t(std::min(rows_.size(), now.size())) - first;
    while (same < shorter && rows_[rows_.size() - 1 - same] == now[now.size() - 1 - same])
        ++same;
    const auto oldEnd = std::ptrdiff_t(rows_.size()) - same;
    const auto newEnd = std::ptrdiff_t(now.size()) - same;
    if (first < oldEnd) {
        beginRemoveRows({}, int(first), int(oldEnd - 1));
        rows_.erase(rows_.begin() + first, rows_.begin() + oldEnd);
        endRemoveRows();
    }
    if (first < newEnd) {
        beginInsertRows({}, int(first), int(newEnd - 1));
        rows_.insert(rows_.begin() + first, now.begin() + first, now.begin() + newEnd);
        endInsertRows();
    }
    changesRows_ = false;
    emit rowsChanged();
}

/// What is found stays in the list, by its new numbers, until the new search is done.
void LayerModel::keepRows(const app::DocumentChange& change)
{
    app::KeptRows kept = app::keptRows(rows_, change.splices, session_.now().containers());
    if (change.again) { // nothing is known of the objects
        kept.rows.clear();
        kept.lost.resize(rows_.size());
        std::iota(kept.lost.begin(), kept.lost.end(), std::size_t(0));
    }
    changesRows_ = true;
    for (auto end = kept.lost.rbegin(); end != kept.lost.rend();) { // runs, from the last one
        auto first = end;
        while (first + 1 != kept.lost.rend() && *(first + 1) + 1 == *first)
            ++first;
        beginRemoveRows({}, int(*first), int(*end));
        rows_.erase(rows_.begin() + std::ptrdiff_t(*first),
                    rows_.begin() + std::ptrdiff_t(*end) + 1);
        endRemoveRows();
        end = first + 1;
    }
    changesRows_ = false;
    rows_ = std::move(kept.rows);
}

bool LayerModel::change(int row, const QVariant& value, int role)
{
    const app::Containers& containers = session_.now().containers();
    const app::TreeRow& changed = rows_[std::size_t(row)];
    const app::ContainerId id = changed.container;
    if (changed.kind == Kind::Object && role == VisibleRole)
        return show(changed.number, value.toBool());
    if (changed.kind == Kind::Object && role == Qt::EditRole)
        return app::nameObject(session_, changed.number, value.toString());
    if (!containers.contains(id) || changed.kind == Kind::Object || changed.kind == Kind::More)
        return false;
    const bool isLayer = changed.kind == Kind::Layer;
    const app::Container before = containers[id];
    app::Container layer = before;
    QString text;
    if (role == VisibleRole) {
        layer.visible = value.toBool();
        text = layer.visible ? isLayer ? Text::tr("Show layer") : Text::tr("Show group")
               : isLayer ? Text::tr("Hide layer")
                             : Text::tr("Hide group");
    } else if (role == LockedRole) {
        layer.locked = value.toBool();
        text = layer.locked ? isLayer ? Text::tr("Lock layer") : Text::tr("Lock group")
               : isLayer ? Text::tr("Unlock layer")
                            : Text::tr("Unlock group");
    } else if (role == Qt::EditRole && !value.toString().trimmed().isEmpty()) {
        layer.name = value.toString().trimmed();
        text = isLayer ? Text::tr("Rename layer") : Text::tr("Rename group");
    }
    if (layer == before)
        return false;
    session_.history.push(new app::SetContainers(session_.document, containers.with(layer), text));
    return true;
}

/// An object alone.
bool LayerModel::show(std::size_t object, bool visible)
{
    if (object >= session_.now().objects().size()
        || session_.now().objects()[object].hidden() != visible)
        return false;
    const app::Containers& containers = session_.now().containers();
    const QString name = app::objectText(session_, object);
    if (containers.locked(containers.containerOf(object))) {
        emit session_.refused(
            Text::tr("%1 is in a locked layer or group. Unlock that first.").arg(name));
        return false;
    }
    const QString text = visible ? Text::tr("Show %1") : Text::tr("Hide %1");
    session_.history.push(
        new app::SetHidden(session_.document, {object}, !visible, text.arg(name)));
    return true;
}

void LayerModel::changeTogether(int first, int last, int role, bool on)
{
    app::TreeRows together;
    for (int row = first; row <= last; ++row) {
        const app::TreeRow& changed = rows_[std::size_t(row)];
        if (changed.kind == Kind::Object)
            together.objects.insert(changed.number);
        else if (changed.kind != Kind::More)
            together.containers.push_back(changed.container);
    }
    role == VisibleRole ? app::show(session_, together, on) : app::lock(session_, together, on);
}

void LayerModel::showOnly(const QModelIndex& index)
{
    app::showOnlyLayer(session_, layerOf(index));
}

bool LayerModel::addLayer()
{
    const app::Containers& tree = session_.now().containers();
    const auto layers = std::ranges::count_if(tree.inOrder(), [&](app::ContainerId id) {
        return tree[id].kind == app::Container::Kind::Layer;
    });
    return app::addLayer(session_, Text::tr("Layer %1").arg(layers + 1));
}

bool LayerModel::mayRemove(app::ContainerId layer) const
{
    const app::Containers& containers = session_.now().containers();
    return containers.contains(layer) && layer != 0
           && (containers.parentOf(layer) != 0 || containers.childrenOf(0).size() > 1);
}

void LayerModel::removeLayer(app::ContainerId layer)
{
    if (mayRemove(layer))
        session_.history.push(new app::RemoveLayer(session_.document, layer));
}

void LayerModel::follow(const app::DocumentChange& change)
{
    if (change.everything) {
        beginResetModel();
        tree_ = {};
        search_.reset();
        rows_ = rowsNow();
        endResetModel();
        showsOld_ = false;
        isOutdated_ = !isSeen_ && !typed_.isEmpty();
        if (!isOutdated_)
            searchAgain();
        return;
    }
    if (!change.containers && !change.objects)
        return;
    if (change.containers)
        tree_.forgetGone(session_.now().containers());
    if (search_) {
        keepRows(change);
        searching_.stop();
        showsOld_ = isOutdated_ = true;
        if (isSeen_)
            searchAgain();
    } else if (change.containers || tree_.isAnyOpen())
        showRows(); // no reset, because it would close an editor that is open on a name
    tellChanged();
}

} // namespace ui

#include "moc_layer_model.cpp"

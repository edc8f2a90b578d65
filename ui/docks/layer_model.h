// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/object_tree.h"
#include "app/session/tree_search.h"
#include "ui/widgets/checked_model.h"

#include <QTimer>

#include <utility>

namespace ui {

/// The layers of the drawing, topmost first, with the groups and objects of those that are open: a
/// list of the rows that are shown, which know their depth. Every change is an undoable step.
class LayerModel : public CheckedModel {
    Q_OBJECT

public:
    enum Role {
        VisibleRole = Qt::UserRole,
        LockedRole,
        CountRole, ///< of the objects of a layer or group; invalid: the row is neither
        DepthRole,
        OpenRole,     ///< invalid: there is nothing to open
        IconRole,     ///< of groups and objects
        SelectedRole, ///< it is selected as a whole
        HoldsRole,    ///< a layer or group with a part of the selection
        PenRole       ///< the layer of new objects
    };
    // Qt::DecorationRole: the layer's colour, else that of its first object

    explicit LayerModel(app::Session& session, QObject* parent = nullptr);

    const app::TreeRow* rowAt(const QModelIndex& index) const;    ///< null: of no row
    app::ContainerId layerOf(const QModelIndex& index) const;     ///< 0: the row is no layer
    app::ContainerId layerAround(const QModelIndex& index) const; ///< the layer of any row
    QModelIndex indexOf(app::ContainerId layerOrGroup) const;
    /// What a row shows: the id of a layer or group, or the number in the name of an object. It
    /// stays when the drawing changes.
    using RowKey = std::pair<app::TreeRow::Kind, std::uint32_t>;
    RowKey keyOf(const app::TreeRow& row) const;
    QModelIndex indexOf(const RowKey& key) const;
    /// Opens what is around the selection, if that is one object or one group. Its row, or the row
    /// of the innermost layer or group around it that is shown.
    QModelIndex revealSelection();
    /// What was opened for that stays open: the person works in it.
    void keepOpen() { tree_.keep(); }

    bool isOpen(const QModelIndex& index) const { return index.data(OpenRole).toBool(); }
    void setOpen(const QModelIndex& index, bool open);
    void showMore(const QModelIndex& index); ///< more of a layer of which only some are shown
    /// Shows only what is found by these words, with the layers and groups around it; nothing
    /// typed: all rows again.
    void find(const QString& typed);
    bool finds() const { return search_.has_value(); }
    std::size_t found() const { return search_ ? search_->found() : 0; }
    /// While the rows are not seen, no change of the drawing starts the search again.
    void setSeen(bool seen);
    /// The first object or group that is found; else the first row.
    QModelIndex firstFound() const;
    /// The objects of groups and objects in these rows that may be selected.
    app::ObjectRanges objectsOf(int first, int last) const;

    /// Sets VisibleRole or LockedRole of these rows, as one step.
    void changeTogether(int first, int last, int role, bool on);
    void showOnly(const QModelIndex& index); ///< hides the others, or shows all again
    bool addLayer(); ///< above all others; false: the drawing has too many layers
    bool mayRemove(app::ContainerId layer) const; ///< false for the last layer
    void removeLayer(app::ContainerId layer);     ///< with the layers nested in it

    /// Whether rows come and go because the document has changed, and nobody chooses one.
    bool changesRows() const { return changesRows_; }

signals:
    void rowsChanged();
    void foundChanged(); ///< how many are found

protected:
    int rows() const override;
    QVariant cell(int row, int column, int role) const override;
    bool change(int row, const QVariant& value, int role) override;
    Qt::ItemFlags moreFlags() const override { return Qt::ItemIsEditable; }

private:
    void follow(const app::DocumentChange& change);
    void showRows();
    std::vector<app::TreeRow> rowsNow() const;
    bool show(std::size_t object, bool visible);
    void searchAgain();
    void searchOn();
    void keepRows(const app::DocumentChange& change);
    QVariant containerCell(const app::TreeRow& row, int role) const;
    QVariant objectCell(const app::TreeRow& row, int role) const;
    QString spoken(const app::TreeRow& row, const QStringList& states) const;
    QVariant moreCell(const app::TreeRow& row, int role) const;
    QVariant selectedCell(const app::TreeRow& row, int role) const;

    app::Session& session_;
    app::ObjectTree tree_;
    std::vector<app::TreeRow> rows_; ///< as last reported to views
    QString typed_;
    std::optional<app::TreeSearch> search_; ///< while something is typed
    std::uint64_t searched_ = 0;            ///< the document's revision in which it searches
    std::size_t most_ = 0;                  ///< rows of what is found
    QTimer searching_;
    bool showsOld_ = false; ///< the rows of the search before, until this one has its own
    bool isSeen_ = true, isOutdated_ = false;
    bool changesRows_ = false;
};

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/layer_steps.h"
#include "ui/docks/layer_model.h"
#include "ui/widgets/panel_list.h"

#include <QKeySequence>

#include <functional>

namespace ui {

/// What can be done with a layer in the panel: by key, and in the menu of the right button.
struct LayerCommand {
    QString text{}; ///< empty: a separator
    QKeySequence key{};
    std::function<void(app::ContainerId)> run{};
    std::function<bool(app::ContainerId)> enabled{}; ///< null: always
};

/// The list of layers, groups and objects. Layers are dragged above, below or into others, groups
/// and objects into layers and groups and between their objects. A click on a group or an object
/// selects it, with Ctrl or Shift also others.
class LayerList : public PanelList {
    Q_OBJECT

public:
    LayerList(app::Session& session, LayerModel* model);

    app::ContainerId layerOf(const QModelIndex& index) const { return layers_->layerOf(index); }
    bool selects() const { return selects_; } ///< while it changes the selection itself
    /// What an eye or padlock over which the pointer is being dragged is going to be.
    std::optional<bool> sweptAs(const QModelIndex& index, int role) const;
    using PanelList::edit;

signals:
    void colourWanted(app::ContainerId layer);
    void objectMenuWanted(const QPoint& place); ///< of the selected objects, on the screen

private:
    /// Where what is dragged would go, and how this is shown.
    struct Target {
        app::ContainerPlace place{}; ///< of a layer
        app::ContainerId into = 0;   ///< of objects: above what ends at or below `at` there
        std::size_t at = 0;
        QRect mark{}; ///< a line between rows, which begins where its level does; or a row
        bool inside = false;
    };

    std::vector<LayerCommand> makeCommands();
    app::ContainerId current() const;
    const LayerCommand* commandOf(const QKeyEvent& event) const;
    /// The row under the pressed button, and what its release does.
    struct Press {
        QPoint at;
        QPersistentModelIndex row;
        bool picksAtRelease = false, showsMore = false, onSign = false;
        std::optional<int> mark{}; ///< the role of an eye or padlock
        int last = 0;              ///< the row to which the pointer was dragged from it
    };
    std::optional<Target> targetAt(const QPoint& at) const;
    std::optional<Target> targetOfObjects(const QPoint& at) const;
    Target below(const QModelIndex& index, int x) const;
    static Target inside(app::ContainerId layerOrGroup, std::size_t end, const QRect& row);
    void sweep(const QPoint& at);
    void releaseSign(QMouseEvent& event, const Press& pressed);
    bool renames(const QKeyEvent& event) const;
    void startDrag();
    void endDrag();
    void select(const app::ObjectRanges& objects);
    void pick(const QModelIndex& index, Qt::KeyboardModifiers modifiers);
    bool treeKey(const QKeyEvent& event);
    void layerMenu(const QModelIndex& index, const QPoint& place);

    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    bool edit(const QModelIndex& index, EditTrigger trigger, QEvent* event) override;

    app::Session& session_;
    LayerModel* layers_;
    std::vector<LayerCommand> commands_;
    std::optional<Press> pressed_;
    app::ContainerId dragged_ = 0; ///< the layer; 0: none is dragged
    bool dragsObjects_ = false;    ///< the selected ones
    bool selects_ = false;
    QPersistentModelIndex anchor_; ///< of what Shift selects
    std::optional<Target> target_;
};

} // namespace ui

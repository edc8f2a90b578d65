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

/// The list of layers. Layers are dragged above, below or into others.
class LayerList : public PanelList {
    Q_OBJECT

public:
    LayerList(app::Session& session, LayerModel* model);

    app::ContainerId layerOf(const QModelIndex& index) const { return layers_->layerOf(index); }

signals:
    void colourWanted(app::ContainerId layer);

private:
    /// Where a dragged layer would go, and how this is shown.
    struct Target {
        app::ContainerPlace place;
        QRect mark; ///< a line between rows, or a row
        bool inside = false;
    };

    std::vector<LayerCommand> makeCommands();
    app::ContainerId current() const;
    const LayerCommand* commandOf(const QKeyEvent& event) const;
    Target targetAt(const QPoint& at) const;
    void endDrag();

    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void paintEvent(QPaintEvent* event) override;

    app::Session& session_;
    LayerModel* layers_;
    std::vector<LayerCommand> commands_;
    std::optional<QPoint> pressed_;
    app::ContainerId dragged_ = 0; ///< 0: no drag
    std::optional<Target> target_;
};

} // namespace ui

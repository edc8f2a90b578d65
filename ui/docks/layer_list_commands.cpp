// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/image_steps.h"
#include "app/session/rearrange_selection.h"
#include "app/session/select_alike.h"
#include "ui/docks/layer_list.h"
#include "ui/look/text.h"

namespace ui {

// THE CATALOGUE. To add a command for a layer: add its row.
std::vector<LayerCommand> LayerList::makeCommands()
{
    using app::ContainerId, app::LayerStep;
    const auto move = [this](LayerStep step) {
        return [this, step](ContainerId layer) { app::moveLayer(session_, layer, step); };
    };
    const auto leads = [this](LayerStep step) {
        return [this, step](ContainerId layer) {
            return app::placeAfter(session_.now().containers(), layer, step).has_value();
        };
    };
    const auto someSelected = [this](ContainerId) { return !session_.selection().empty(); };
    const auto set = [this](LayerModel::Role role, bool value) {
        return [this, role, value](ContainerId layer) {
            layers_->setData(layers_->indexOf(layer), value, role);
        };
    };
    const auto is = [this](LayerModel::Role role, bool value) {
        return [this, role, value](ContainerId layer) {
            return layers_->indexOf(layer).data(role).toBool() == value;
        };
    };
    return {
        {Text::tr("Rename"), QKeySequence(Qt::Key_F2),
         [this](ContainerId layer) { edit(layers_->indexOf(layer)); }},
        {Text::tr("Colour of new objects…"),
         {},
         [this](ContainerId layer) { emit colourWanted(layer); }},
        {Text::tr("Hide"),
         {},
         set(LayerModel::VisibleRole, false),
         is(LayerModel::VisibleRole, true)},
        {Text::tr("Show"),
         {},
         set(LayerModel::VisibleRole, true),
         is(LayerModel::VisibleRole, false)},
        {Text::tr("Lock"),
         {},
         set(LayerModel::LockedRole, true),
         is(LayerModel::LockedRole, false)},
        {Text::tr("Unlock"),
         {},
         set(LayerModel::LockedRole, false),
         is(LayerModel::LockedRole, true)},
        {Text::tr("Show only this layer"),
         {},
         [this](ContainerId layer) { app::showOnlyLayer(session_, layer); },
         [this](ContainerId) { return session_.now().containers().size() > 1; }},
        {},
        {Text::tr("Move up"), QKeySequence("Alt+Up"), move(LayerStep::Up), leads(LayerStep::Up)},
        {Text::tr("Move down"), QKeySequence("Alt+Down"), move(LayerStep::Down),
         leads(LayerStep::Down)},
        {Text::tr("Put into the layer above"), QKeySequence("Alt+Right"), move(LayerStep::Inward),
         leads(LayerStep::Inward)},
        {Text::tr("Move out of its layer"), QKeySequence("Alt+Left"), move(LayerStep::Outward),
         leads(LayerStep::Outward)},
        {},
        {Text::tr("Select everything in it"),
         {},
         [this](ContainerId layer) { app::selectLayer(session_, layer); }},
        {Text::tr("Move the selection here"),
         {},
         [this](ContainerId layer) { app::moveSelectionTo(session_, layer); },
         someSelected},
        {},
        {Text::tr("Remove image"),
         {},
         [this](ContainerId layer) { app::removeImage(session_, layer); },
         [this](ContainerId layer) {
             const app::Containers& tree = session_.now().containers();
             return layer != 0 && tree.contains(layer) && tree[layer].underlay;
         }},
        {Text::tr("Delete layer"),
         {},
         [this](ContainerId layer) { layers_->removeLayer(layer); },
         [this](ContainerId layer) { return layers_->mayRemove(layer); }},
    };
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tools/group_choice.h"

#include "ui/look/text.h"
#include "ui/tools/shape_drawing.h"

namespace ui {

bool choose(std::optional<std::size_t> object, Qt::KeyboardModifiers modifiers,
            app::Session& session)
{
    auto selection = modifiers & Qt::ShiftModifier ? session.selection() : app::ObjectRanges{};
    if (!object) {
        session.select(std::move(selection));
        return false;
    }
    const bool alone = modifiers & Qt::AltModifier;
    const app::ObjectRanges unit =
        alone ? app::ObjectRanges{*object} : app::unitAt(session, *object);
    if (!alone) {
        const app::Containers& tree = session.now().containers();
        const app::ContainerId group = app::groupAt(session, *object);
        session.entered.enter(group ? tree.parentOf(group) : tree.containerOf(*object));
    }
    const bool adds = !without(unit, selection).empty();
    session.select(adds ? united(selection, unit) : without(selection, unit));
    return adds;
}

void refuseLocked(const Pointer& pointer, const Workbench& bench)
{
    const auto lines = bench.picking.near(pointer.raw, bench.inDrawing(reach), {});
    if (lines.empty())
        return;
    const app::Containers& tree = bench.session.now().containers();
    app::ContainerId id = tree.containerOf(bench.session.scene.lines().objectOf(lines.back()));
    while (id != 0 && !tree[id].locked)
        id = tree.parentOf(id);
    if (id != 0)
        emit bench.session.refused(Text::tr("%1 is locked. Unlock it in the panel Layers to "
                                            "select what is in it.")
                                       .arg(app::groupName(tree[id])));
}

bool enterGroupAt(app::Session& session, std::size_t object)
{
    const app::ContainerId group = app::groupAt(session, object);
    if (group == 0)
        return false;
    session.entered.enter(group);
    session.select(app::unitAt(session, object));
    return true;
}

bool openAt(std::size_t object, Workbench& bench)
{
    if (enterGroupAt(bench.session, object))
        return true;
    if (!isText(bench.session, object))
        return false;
    bench.session.select({object});
    bench.nextObject = object;
    bench.nextTool = "text";
    return true;
}

void leaveGroup(app::Session& session)
{
    const auto group = session.now().containers().rangeOf(session.entered.id());
    session.entered.leave();
    session.inspect(std::nullopt);
    session.select(app::unitsOf(session, app::ObjectRanges(group), app::FoundGroups::Any));
}

} // namespace ui

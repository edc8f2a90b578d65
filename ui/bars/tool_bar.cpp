// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/tool_bar.h"

#include "app/base/text.h"
#include "ui/look/key_tip.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/tools/tool.h"

#include <QAction>
#include <QActionGroup>

namespace ui {

ToolBar::ToolBar(app::Session& session, Canvas& canvas)
    : QToolBar(Text::tr("Tools")), session_(session), canvas_(canvas)
{
    setObjectName(QStringLiteral("tools"));
    setIconSize({20, 20});
    setFixedWidth(space::toolBarWidth);
    auto* group = new QActionGroup(this);
    for (const ToolInfo& tool : ui::tools()) {
        if (tool.group == ToolInfo::Group::New)
            addSeparator();
        QAction* action = makeAction(tool);
        group->addAction(action);
        canvas.addAction(action);
        tools_ << action;
        addTool(action);
    }
}

QAction* ToolBar::makeAction(const ToolInfo& tool)
{
    auto* action = new QAction(icon(tool.key), tool.name, this);
    action->setObjectName(QStringLiteral("tool-") + app::latin(tool.key));
    action->setShortcut(tool.shortcut);
    action->setShortcutContext(Qt::WidgetWithChildrenShortcut);
    const auto showKey = [action, &tool] { action->setToolTip(nameWithKey(tool.name, *action)); };
    connect(action, &QAction::changed, action, showKey);
    showKey();
    action->setCheckable(true);
    connect(action, &QAction::triggered, &canvas_, [this, key = tool.key] {
        session_.microscope.close();
        canvas_.setTool(key);
        canvas_.setFocus();
    });
    const auto follow = [this, action, key = tool.key] {
        action->setChecked(canvas_.tool() == key);
    };
    connect(&canvas_, &Canvas::toolChanged, action, follow);
    follow();
    return action;
}

void ToolBar::addTool(QAction* action)
{
    addAction(action);
    if (QWidget* button = widgetForAction(action))
        button->setFixedSize(space::toolButton, space::toolButton);
}

} // namespace ui

#include "moc_tool_bar.cpp"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/bars/node_row.h"

#include "ui/look/key_tip.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/elements.h"

#include <QAction>
#include <QHelpEvent>
#include <QToolButton>
#include <QToolTip>

#include <algorithm>
#include <array>

namespace ui {
namespace {

constexpr int between = 7, ruleHeight = 18; // pixels beside a rule
/// The steps that begin a group of buttons.
const std::array groups{QStringLiteral("straighten-segments"), QStringLiteral("add-nodes"),
                        QStringLiteral("split-path")};

/// A button whose tooltip names the command and its key, and why it is disabled.
class StepButton : public QToolButton {
public:
    explicit StepButton(QAction& action)
    {
        setDefaultAction(&action);
        setAutoRaise(true);
        setIconSize({18, 18});
        setFixedSize(space::toolButton, space::toolButton);
        setFocusPolicy(Qt::NoFocus);
        setAccessibleName(action.iconText());
    }

protected:
    bool event(QEvent* event) override
    {
        if (event->type() != QEvent::ToolTip)
            return QToolButton::event(event);
        QToolTip::showText(static_cast<QHelpEvent*>(event)->globalPos(), tip(), this);
        return true;
    }

private:
    QString tip() const
    {
        const QAction& action = *defaultAction();
        const QString name = nameWithKey(action.iconText(), action);
        return action.isEnabled() ? name : name + u'\n' + action.statusTip();
    }
};

} // namespace

NodeRow::NodeRow(QWidget* parent) : QWidget(parent), row_(new QHBoxLayout(this))
{
    row_->setContentsMargins(0, 0, 0, 0);
    row_->setSpacing(2);
}

void NodeRow::add(QAction& action)
{
    if (std::ranges::find(groups, action.objectName()) != groups.end()) {
        row_->addSpacing(between);
        QFrame* line = rule(Qt::Vertical);
        line->setFixedHeight(ruleHeight);
        row_->addWidget(line);
        row_->addSpacing(between);
    }
    row_->addWidget(new StepButton(action));
}

} // namespace ui

#include "moc_node_row.cpp"

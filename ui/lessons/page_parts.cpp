// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/page_parts.h"

#include "ui/lessons/choice_list.h"
#include "ui/lessons/page_dots.h"
#include "ui/look/look.h"
#include "ui/look/look_icon.h"
#include "ui/look/text.h"
#include "ui/widgets/link_button.h"

#include <QLabel>
#include <QToolButton>

namespace ui {

QToolButton* linkToLessons()
{
    auto* all = linkButton();
    all->setText(Text::tr("All lessons"));
    all->setToolTip(Text::tr("Show all lessons"));
    all->setAccessibleName(all->toolTip());
    return all;
}

QVBoxLayout* pageHead(QLabel& place, QToolButton& all, QLabel& title)
{
    place.setForegroundRole(QPalette::PlaceholderText);
    wearFont(title, pageType::title, QFont::Bold);
    title.setWordWrap(true);
    auto* row = new QHBoxLayout;
    row->addWidget(&place, 1);
    row->addWidget(&all);
    auto* head = new QVBoxLayout;
    head->setSpacing(space::labelToField);
    head->addLayout(row);
    head->addWidget(&title);
    return head;
}

void makePageBody(QScrollArea& body, QWidget& inner)
{
    body.setFrameShape(QFrame::NoFrame);
    body.setWidgetResizable(true);
    body.setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    body.setFocusPolicy(Qt::NoFocus);
    body.setWidget(&inner);
}

void markAnswer(QPushButton& button, bool right)
{
    const Look& look = lookOf(button.palette());
    button.setIcon(icon(right ? "tick" : "close"));
    button.setAccessibleDescription(right ? Text::tr("right") : Text::tr("chosen, and wrong"));
    QPalette colours = button.palette();
    for (const auto group : {QPalette::Active, QPalette::Inactive, QPalette::Disabled})
        colours.setColor(group, QPalette::ButtonText, right ? look.good : errorColour(look));
    button.setPalette(colours);
}

QHBoxLayout* pageFoot(PageDots& dots, QLabel& count, std::initializer_list<QPushButton*> turns)
{
    count.setForegroundRole(QPalette::PlaceholderText);
    auto* foot = new QHBoxLayout;
    foot->setSpacing(space::labelToField);
    foot->addWidget(&dots);
    foot->addWidget(&count);
    foot->addStretch();
    for (QPushButton* turn : turns)
        foot->addWidget(turn);
    return foot;
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/leftovers_dialog.h"

#include "app/session/recent_files.h"
#include "ui/dialogs/leftover_picture.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/panel_list.h"

#include <QDialog>
#include <QDialogButtonBox>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QLabel>
#include <QLocale>
#include <QPushButton>
#include <QTreeWidget>
#include <QVBoxLayout>

namespace ui {

namespace {

using Verb = Questions::LeftoverAnswer::Verb;

constexpr int listWidth = 340;

QString timeText(const QDateTime& time)
{
    const QDateTime here = time.toLocalTime();
    return Text::tr("%1, %2").arg(app::dayText(here.date(), QDate::currentDate()),
                                  QLocale().toString(here.time(), QStringLiteral("HH:mm")));
}

QTreeWidget* makeList(const std::vector<app::Leftover>& leftovers)
{
    auto* list = new QTreeWidget;
    list->setAccessibleName(Text::tr("Unsaved drawings"));
    list->setRootIsDecorated(false);
    list->setUniformRowHeights(true);
    list->setHeaderLabels({Text::tr("Drawing"), Text::tr("Last change")});
    list->header()->setStretchLastSection(false);
    list->header()->setSectionResizeMode(0, QHeaderView::Stretch);
    list->header()->setSectionResizeMode(1, QHeaderView::ResizeToContents);
    for (const app::Leftover& leftover : leftovers) {
        auto* row = new QTreeWidgetItem(list, {leftover.origin.name, timeText(leftover.ended)});
        row->setSizeHint(0, {0, space::rowHeight});
        row->setToolTip(0, leftover.origin.path);
    }
    list->setCurrentItem(list->topLevelItem(0));
    keepChoice(*list);
    return list;
}

} // namespace

Questions::LeftoverAnswer askAboutLeftovers(QWidget& window,
                                            const std::vector<app::Leftover>& leftovers)
{
    QDialog dialog(&window);
    dialog.setObjectName(QStringLiteral("leftovers"));
    dialog.setWindowTitle(Text::tr("Unsaved drawings"));
    auto* column = new QVBoxLayout(&dialog);
    auto* sentence = new QLabel(leftovers.size() == 1
                                    ? Text::tr("Clearcut ended before this drawing was saved.")
                                    : Text::tr("Clearcut ended before these drawings were saved."));
    column->addWidget(sentence);
    auto* list = makeList(leftovers);
    list->setMinimumWidth(listWidth);
    auto* picture = new LeftoverPicture;
    list->setFixedHeight(picture->height());
    const auto showCurrent = [=, &leftovers](QTreeWidgetItem* current) {
        picture->showPicture(leftovers[std::size_t(list->indexOfTopLevelItem(current))]);
    };
    QObject::connect(list, &QTreeWidget::currentItemChanged, picture, showCurrent);
    showCurrent(list->currentItem());
    auto* row = new QHBoxLayout;
    row->addWidget(list, 1);
    row->addWidget(picture);
    column->addLayout(row);
    auto* buttons = new QDialogButtonBox;
    auto* recover = buttons->addButton(Text::tr("Recover drawing"), QDialogButtonBox::AcceptRole);
    auto* discard =
        buttons->addButton(Text::tr("Discard drawing"), QDialogButtonBox::DestructiveRole);
    buttons->addButton(Text::tr("Keep for later"), QDialogButtonBox::RejectRole);
    recover->setDefault(true);
    recover->setFocus();
    discard->setAutoDefault(false);
    column->addWidget(buttons);
    Verb verb = Verb::Later;
    const auto end = [&](Verb chosen) {
        return [&dialog, &verb, chosen] {
            verb = chosen;
            dialog.accept();
        };
    };
    QObject::connect(recover, &QPushButton::clicked, &dialog, end(Verb::Recover));
    QObject::connect(discard, &QPushButton::clicked, &dialog, end(Verb::Discard));
    QObject::connect(buttons, &QDialogButtonBox::rejected, &dialog, &QDialog::reject);
    QObject::connect(list, &QTreeWidget::itemDoubleClicked, recover, &QPushButton::click);
    dialog.exec();
    return {verb, std::size_t(list->indexOfTopLevelItem(list->currentItem()))};
}

} // namespace ui

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/window_panel.h"

#include "app/base/keys_in_use.h"
#include "app/session/window_steps.h"
#include "app/session/window_words.h"
#include "ui/docks/window_add_menu.h"
#include "ui/docks/window_fields.h"
#include "ui/docks/window_list.h"
#include "ui/editing/keeping.h"
#include "ui/look/key_tip.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/elements.h"
#include "ui/widgets/segments.h"

#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace ui {

WindowPanel::WindowPanel(app::Session& session, QWidget* parent)
    : QWidget(parent), session_(session), list_(new WindowList(session)),
      keep_(new Segments(Text::tr("Keep"), {Text::tr("Inside"), Text::tr("Outside")})),
      fields_(new WindowFields(session)), pages_(new QStackedLayout(this))
{
    pages_->addWidget(makeList());
    pages_->addWidget(makeOffer());
    setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Maximum);
    connect(fields_, &WindowFields::entered, this, &WindowPanel::entered);
    connect(fields_, &WindowFields::refused, this, &WindowPanel::refused);
    connect(fields_, &WindowFields::taken, this, &WindowPanel::taken);
    connect(&session, &app::Session::previewChanged, this, &WindowPanel::follow);
    list_->setContextMenuPolicy(Qt::CustomContextMenu);
    connect(list_, &QWidget::customContextMenuRequested, this, [this](const QPoint& at) {
        // A hidden window is not the one that tools act on.
        const QModelIndex row = list_->indexAt(at);
        if (row.isValid() && std::size_t(row.row()) == session_.windowNumber())
            emit menuWanted(list_->viewport()->mapToGlobal(at));
    });
    follow();
}

void WindowPanel::rename()
{
    if (list_->currentIndex().isValid())
        list_->edit(list_->currentIndex());
}

void WindowPanel::showSize(bool shown) { fields_->showSize(shown); }

QWidget* WindowPanel::makeList()
{
    auto* page = new QWidget;
    auto* column = new QVBoxLayout(page);
    column->setContentsMargins(0, 4, 0, 0);
    column->setSpacing(0);
    column->addWidget(makeKeep());
    column->addWidget(list_);
    column->addWidget(fields_);
    keepPlaceWhenHidden(*fields_);
    return page;
}

QWidget* WindowPanel::makeKeep()
{
    keep_->setObjectName(QStringLiteral("keep"));
    followKeys(*keep_, [this] {
        keep_->setTips({app::withKeys(Text::tr("Keep what lies inside all windows together "
                                               "({keep-outside}: the other side)")),
                        app::withKeys(Text::tr("Keep what lies outside all windows together "
                                               "({keep-outside}: the other side)"))});
    });
    connect(keep_, &Segments::picked, this, [this](int side) {
        setKeep(session_, app::Keep(side));
        emit entered();
    });
    auto* caption = new QLabel(Text::tr("Keep"));
    caption->setForegroundRole(QPalette::PlaceholderText);
    auto* row = new QHBoxLayout;
    row->setContentsMargins(space::dockMargin, 0, space::dockMargin - 4, 4);
    row->setSpacing(space::labelToField);
    row->addWidget(caption);
    row->addWidget(keep_);
    row->addStretch();
    addTools(*row);
    auto* side = new QWidget;
    side->setLayout(row);
    return side;
}

void WindowPanel::addTools(QHBoxLayout& row)
{
    QToolButton* add = makeAdd();
    add->setObjectName(QStringLiteral("add-window"));
    auto* remove = iconButton("bin", Text::tr("Remove the clip window"));
    connect(remove, &QToolButton::clicked, this, [this] { app::removeWindow(session_); });
    row.addWidget(add);
    row.addWidget(remove);
}

QToolButton* WindowPanel::makeAdd()
{
    QToolButton* add = iconButton("plus", Text::tr("Add a clip window"));
    add->setPopupMode(QToolButton::InstantPopup);
    add->setStyleSheet(QStringLiteral("QToolButton::menu-indicator { image: none; }"));
    add->setMenu(makeWindowAddMenu(session_, *this));
    return add;
}

QWidget* WindowPanel::makeOffer()
{
    auto* text = new QLabel;
    followKeys(*text, [text] {
        text->setText(app::withKeys(
            Text::tr("There is no clip window, so nothing is cut. Draw one ({tool-window}), or:")));
    });
    text->setWordWrap(true);
    auto* button = new QPushButton(Text::tr("Lay window on page"));
    button->setToolTip(Text::tr("Add a clip window that covers the whole page"));
    connect(button, &QPushButton::clicked, this, [this] {
        layWindowOnPage(session_);
        fields_->startTyping(); // its numbers are typed next
    });
    auto* row = new QHBoxLayout;
    row->addWidget(button);
    row->addWidget(makeAdd());
    row->addStretch();
    auto* column = new QVBoxLayout;
    column->setContentsMargins(space::dockMargin, space::labelToField, space::dockMargin,
                               space::dockMargin);
    column->setSpacing(space::labelToField);
    column->addWidget(text);
    column->addLayout(row);
    column->addStretch();
    auto* offer = new QWidget;
    offer->setLayout(column);
    return offer;
}

void WindowPanel::follow()
{
    pages_->setCurrentIndex(session_.windows().list.empty() ? 1 : 0);
    keep_->choose(int(session_.windows().keep));
    fields_->setVisible(session_.windowNumber().has_value()); // of a hidden one there are none
    constexpr std::size_t most = 6; // then the list scrolls: about half of a low column
    const std::size_t rows = std::clamp<std::size_t>(session_.windows().list.size(), 1, most);
    list_->setFixedHeight(int(rows) * space::rowHeight);
    emit titled(title());
}

QString WindowPanel::title() const
{
    const QString result = app::resultOf(session_.windows());
    return result.isEmpty() || session_.windows().keep == app::Keep::Inside
               ? result
               : Text::tr("all but %1", "what the clip windows keep").arg(result);
}

} // namespace ui

#include "moc_window_panel.cpp"

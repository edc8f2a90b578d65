// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/dock.h"

#include "app/base/text.h"
#include "ui/docks/dock_title.h"
#include "ui/look/look.h"

namespace ui {

Dock::Dock(std::string_view key, const QString& title, QWidget* body, QWidget* parent)
    : QDockWidget(title, parent), title_(new DockTitle(*this)), noTitle_(new QWidget(this)),
      body_(body), nothing_(new QWidget(this))
{
    setObjectName(app::latin(key));
    setAccessibleName(title);
    setWidget(body);
    body->setAutoFillBackground(true);
    body->setBackgroundRole(QPalette::Button);
    setTitleBarWidget(title_);
    for (QWidget* flat : {noTitle_, nothing_}) {
        flat->setFixedHeight(0);
        flat->hide();
    }
    connect(title_, &DockTitle::foldWanted, this, &Dock::foldWanted);
}

void Dock::setFoldable(bool foldable)
{
    foldable_ = foldable;
    title_->setFoldable(foldable);
}

void Dock::setFolded(bool folded)
{
    folded_ = folded;
    showFolded();
}

void Dock::showFolded()
{
    const bool onlyTitle = folded_ && titleBarWidget() == title_;
    title_->showFolded(onlyTitle);
    // A hidden body would not let the column be wider than the headings need.
    if (QWidget* shown = onlyTitle ? nothing_ : body_; shown != widget())
        setWidget(shown);
}

void Dock::setTitle(Title where)
{
    QWidget* wanted = where == Title::Shown ? static_cast<QWidget*>(title_) : noTitle_;
    QWidget* other = where == Title::Shown ? noTitle_ : static_cast<QWidget*>(title_);
    if (titleBarWidget() == wanted)
        return;
    setTitleBarWidget(wanted);
    other->hide();
    wanted->show();
    showFolded();
}

} // namespace ui

#include "moc_dock.cpp"

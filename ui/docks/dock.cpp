// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/dock.h"

#include "app/base/text.h"
#include "ui/docks/dock_title.h"
#include "ui/look/look.h"

namespace ui {

Dock::Dock(std::string_view key, const QString& title, QWidget* body, QWidget* parent)
    : QDockWidget(title, parent), title_(new DockTitle(*this)), noTitle_(new QWidget(this))
{
    setObjectName(app::latin(key));
    setAccessibleName(title);
    setWidget(body);
    body->setAutoFillBackground(true);
    body->setBackgroundRole(QPalette::Button);
    setTitleBarWidget(title_);
    noTitle_->setFixedHeight(0);
    noTitle_->hide();
}

void Dock::setName(const QString& name) { title_->setName(name); }

void Dock::setRemark(const QString& remark)
{
    remark_ = remark;
    showFolded();
}

void Dock::setFoldable(bool foldable)
{
    title_->setFoldable(foldable);
    connect(title_, &DockTitle::foldWanted, this, &Dock::foldWanted);
}

void Dock::setFolded(bool folded)
{
    folded_ = folded;
    showFolded();
}

void Dock::setFoldedRemark(const QString& remark)
{
    foldedRemark_ = remark;
    showFolded();
}

void Dock::showFolded()
{
    const bool onlyTitle = folded_ && titleBarWidget() == title_;
    title_->setRemark(onlyTitle ? foldedRemark_ : remark_);
    title_->showFolded(onlyTitle);
    widget()->setVisible(!onlyTitle);
    setMaximumHeight(onlyTitle ? space::dockTitleHeight : QWIDGETSIZE_MAX);
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

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/docks/dock.h"

#include "app/base/latin.h"
#include "ui/docks/dock_title.h"

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

void Dock::setRemark(const QString& remark) { title_->setRemark(remark); }

void Dock::setTitle(Title where)
{
    QWidget* wanted = where == Title::Shown ? static_cast<QWidget*>(title_) : noTitle_;
    QWidget* other = where == Title::Shown ? noTitle_ : static_cast<QWidget*>(title_);
    if (titleBarWidget() == wanted)
        return;
    setTitleBarWidget(wanted);
    other->hide();
    wanted->show();
}

} // namespace ui

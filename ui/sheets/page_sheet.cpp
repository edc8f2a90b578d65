// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/sheets/page_sheet.h"

#include "app/session/last_page.h"
#include "ui/canvas/canvas.h"
#include "ui/files/files.h"
#include "ui/look/look.h"
#include "ui/look/text.h"
#include "ui/sheets/background_section.h"
#include "ui/sheets/margins_section.h"
#include "ui/sheets/page_frame.h"
#include "ui/sheets/paper_section.h"
#include "ui/sheets/scale_section.h"
#include "ui/widgets/buttons.h"
#include "ui/widgets/elements.h"
#include "ui/widgets/look_label.h"
#include "ui/window/main_window.h"

#include <QAbstractSpinBox>
#include <QKeyEvent>
#include <QSettings>

namespace ui {

PageSheet::PageSheet(MainWindow& window)
    : Sheet(QStringLiteral("page"), Text::tr("Page")), session_(window.session()),
      canvas_(window.canvas()), editing_(session_), check_(new LookLabel),
      frame_(new PageFrame(canvas_, session_, editing_)), shown_(session_.now().page())
{
    setRemark(window.files().name());
    sections_ = {new PaperSection(session_, editing_), new ScaleSection(session_, editing_),
                 new MarginsSection(session_, editing_), new BackgroundSection(session_, editing_)};
    for (PageSection* section : sections_) {
        body().addWidget(section);
        body().addWidget(rule(Qt::Horizontal));
        connect(section, &PageSection::entered, this, &PageSheet::keep);
    }
    addCheck();
    body().addStretch();
    addFootButtons();
    soon_.setSingleShot(true);
    connect(&soon_, &QTimer::timeout, this, &PageSheet::check);
    connect(&session_.document, &app::EditedDocument::changed, this, &PageSheet::follow);
    connect(&session_, &app::Session::displayChanged, this, [this] {
        for (PageSection* section : sections_)
            section->follow();
    });
    connect(&session_, &app::Session::loaded, this, &Sheet::closeWanted); // of another drawing
    check();
}

PageSheet::~PageSheet() { delete frame_; }

/// It is closed, or another sheet takes its place.
void PageSheet::hideEvent(QHideEvent* event)
{
    Sheet::hideEvent(event);
    if (frame_)
        frame_->hide();
}

void PageSheet::addFootButtons()
{
    auto* cancel = plainButton(Text::tr("Cancel"));
    auto* done = plainButton(Text::tr("Done"));
    cancel->setObjectName(QStringLiteral("cancel"));
    done->setObjectName(QStringLiteral("done"));
    done->setDefault(true);
    addToFoot(cancel);
    addToFoot(done);
    connect(cancel, &QPushButton::clicked, this, &PageSheet::leave);
    connect(done, &QPushButton::clicked, this, &PageSheet::keep);
}

void PageSheet::addCheck()
{
    auto* row = new QVBoxLayout;
    row->setContentsMargins(space::dockMargin, space::dockMargin, space::dockMargin,
                            space::dockMargin);
    check_->setTextFormat(Qt::RichText);
    check_->setWordWrap(true);
    check_->setObjectName(QStringLiteral("page-check"));
    row->addWidget(check_);
    body().addLayout(row);
    connect(check_, &QLabel::linkActivated, this,
            [this] { session_.select(app::checkedPage(session_).outside); });
}

void PageSheet::leave()
{
    if (QWidget* field = focusWidget())
        field->clearFocus(); // what is being typed is taken back, too
    editing_.cancel();
    Sheet::leave();
}

/// The next new drawing has this page, too.
void PageSheet::keep()
{
    QSettings().setValue("page", app::pageText(session_.now().page()));
    emit closeWanted();
}

void PageSheet::follow(const app::DocumentChange& change)
{
    if (change.drawing())
        soon_.start(0);
    const app::Page& page = session_.now().page();
    if (isHidden() || !change.page || page == shown_) // hidden: it is closed already
        return;
    const bool moved = page.min != shown_.min || page.size != shown_.size;
    shown_ = page;
    for (PageSection* section : sections_)
        section->follow();
    if (moved && !(frame_ && frame_->isDragged()))
        canvas_.fitPage();
}

void PageSheet::keyPressEvent(QKeyEvent* event)
{
    if (event->key() != Qt::Key_Return && event->key() != Qt::Key_Enter)
        return Sheet::keyPressEvent(event);
    if (!qobject_cast<QAbstractSpinBox*>(focusWidget())) // a field says itself whether it took it
        keep();                                          // as Done does
}

void PageSheet::check()
{
    const app::PageCheck found = app::checkedPage(session_);
    check_->setColour([good = found.outside.empty()](const Look& look) {
        return good ? look.good : look.warning;
    });
    const QString link = QStringLiteral(" <a href=\"#\">%1</a>").arg(Text::tr("Select them"));
    const QString text = found.text.toHtmlEscaped();
    check_->setText(found.outside.empty() ? text : text + link);
}

} // namespace ui

#include "moc_page_sheet.cpp"

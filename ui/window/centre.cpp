// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/centre.h"

#include "ui/canvas/canvas.h"
#include "ui/microscope/microscope_page.h"
#include "ui/tiles/tiles_page.h"
#include "ui/widgets/message_strip.h"
#include "ui/widgets/sheet.h"

#include <QEvent>
#include <QStackedWidget>
#include <QVBoxLayout>

#include <utility>

namespace ui {

Centre::Centre(MessageStrip& strip, Canvas& canvas)
    : pages_(new QStackedWidget), column_(new QVBoxLayout), messages_(new QWidget(this)),
      canvas_(canvas)
{
    auto* across = new QHBoxLayout(this);
    across->setContentsMargins(0, 0, 0, 0);
    across->setSpacing(0);
    across->addLayout(column_, 1);
    pages_->addWidget(&canvas);
    column_->addWidget(pages_);
    auto* messages = new QVBoxLayout(messages_);
    messages->setContentsMargins(0, 0, 0, 0);
    messages->setSpacing(0);
    messages->addWidget(&strip);
    messages_->raise();
    messages_->installEventFilter(this);
    connect(&canvas, &Canvas::panesChanged, this, &Centre::placeMessages);
}

void Centre::addNote(WindowNote& note)
{
    note_ = &note;
    static_cast<QVBoxLayout*>(messages_->layout())->insertWidget(0, &note);
    connect(&note, &WindowNote::learnt, this,
            [this] { std::exchange(note_, nullptr)->deleteLater(); });
}

void Centre::allowNote(bool allowed)
{
    noteAllowed_ = allowed;
    if (note_)
        note_->setVisible(allowed && showsCanvas());
}

void Centre::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    if (sheet_)
        sheet_->fitTo(window()->width());
    placeMessages();
}

bool Centre::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == (watched == messages_ ? QEvent::LayoutRequest : QEvent::Resize))
        placeMessages();
    return QWidget::eventFilter(watched, event);
}

void Centre::placeMessages()
{
    const bool showsTiles = tiles_ && pages_->currentWidget() == tiles_;
    const QPoint corner = showsCanvas() ? canvas_.drawingCorner()
                          : showsTiles  ? tiles_->sheetsArea().topLeft()
                                        : QPoint();
    const int across =
        showsTiles ? tiles_->sheetsArea().width() : column_->geometry().width() - corner.x();
    const QLayout& messages = *messages_->layout();
    const int height = messages.isEmpty()             ? 0
                       : messages.hasHeightForWidth() ? messages.heightForWidth(across)
                                                      : messages.sizeHint().height();
    messages_->setGeometry(corner.x(), corner.y(), across, height);
    column_->setContentsMargins(0, showsCanvas() || showsTiles ? 0 : height, 0, 0);
}

void Centre::setMicroscope(MicroscopePage* page)
{
    if (microscope_)
        microscope_->deleteLater();
    microscope_ = page;
    pages_->addWidget(page);
}

void Centre::setTiles(TilesPage* page)
{
    tiles_ = page;
    page->view().installEventFilter(this);
    pages_->addWidget(page);
}

void Centre::setSheet(Sheet* sheet)
{
    if (sheet_) {
        if (QWidget* preview = sheet_->preview()) {
            pages_->removeWidget(preview);
            preview->deleteLater();
        }
        sheet_->hide();
        layout()->removeWidget(sheet_);
        sheet_->deleteLater();
    }
    sheet_ = sheet;
    if (sheet) {
        if (sheet->preview())
            pages_->addWidget(sheet->preview());
        static_cast<QHBoxLayout*>(layout())->addWidget(sheet);
        sheet->show();
        sheet->fitTo(window()->width());
    }
    placeMessages();
}

void Centre::showTiles() { show(*tiles_); }

void Centre::showCanvas() { show(canvas_); }

void Centre::showMicroscope() { show(*microscope_); }

void Centre::showPreview() { show(*sheet_->preview()); }

bool Centre::showsCanvas() const { return pages_->currentWidget() == &canvas_; }

/// A stacked widget is at least as large as its largest page, hidden ones included, so hidden pages
/// are made to ask for no room.
void Centre::show(QWidget& page)
{
    if (pages_->count() == 1) { // perhaps again: a preview has gone
        if (note_)
            note_->setVisible(noteAllowed_);
        return placeMessages();
    }
    for (QWidget* other : {static_cast<QWidget*>(microscope_), static_cast<QWidget*>(tiles_),
                           sheet_ ? sheet_->preview() : nullptr})
        if (other) {
            const auto policy = other == &page ? QSizePolicy::Preferred : QSizePolicy::Ignored;
            other->setSizePolicy(policy, policy);
        }
    if (note_)
        note_->setVisible(noteAllowed_ && &page == &canvas_);
    pages_->setCurrentWidget(&page);
    placeMessages();
    layOut();
}

void Centre::layOut()
{
    for (QLayout* around : {pages_->layout(), layout(), window()->layout()}) {
        around->invalidate();
        around->activate();
    }
}

} // namespace ui

#include "moc_centre.cpp"

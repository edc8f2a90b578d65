// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/centre.h"

#include "ui/canvas/canvas.h"
#include "ui/microscope/microscope_page.h"
#include "ui/widgets/message_strip.h"
#include "ui/widgets/window_note.h"

#include <QStackedWidget>
#include <QVBoxLayout>

#include <utility>

namespace ui {

Centre::Centre(MessageStrip& strip, Canvas& canvas) : pages_(new QStackedWidget), canvas_(canvas)
{
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    column->addWidget(&strip);
    pages_->addWidget(&canvas);
    column->addWidget(pages_, 1);
}

void Centre::addNote(WindowNote& note)
{
    note_ = &note;
    static_cast<QVBoxLayout*>(layout())->insertWidget(0, &note);
    connect(&note, &WindowNote::learnt, this,
            [this] { std::exchange(note_, nullptr)->deleteLater(); });
}

void Centre::setMicroscope(MicroscopePage* page)
{
    if (microscope_)
        microscope_->deleteLater();
    microscope_ = page;
    pages_->addWidget(page);
}

void Centre::showCanvas() { show(canvas_); }

void Centre::showMicroscope() { show(*microscope_); }

bool Centre::showsCanvas() const { return pages_->currentWidget() == &canvas_; }

/// A stacked widget is at least as large as its largest page, hidden ones included, so the hidden
/// microscope is made to ask for no room.
void Centre::show(QWidget& page)
{
    if (!microscope_)
        return;
    const bool microscope = &page == microscope_;
    const auto policy = microscope ? QSizePolicy::Preferred : QSizePolicy::Ignored;
    microscope_->setSizePolicy(policy, policy);
    if (note_)
        note_->setVisible(!microscope);
    pages_->setCurrentWidget(&page);
    for (QLayout* around : {pages_->layout(), layout(), window()->layout()}) {
        around->invalidate();
        around->activate();
    }
}

} // namespace ui

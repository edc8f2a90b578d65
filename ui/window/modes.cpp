// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/window/modes.h"

#include "ui/widgets/sheet.h"
#include "ui/window/centre.h"
#include "ui/window/panel_layout.h"

#include <QToolBar>

#include <utility>

namespace ui {

Mode modeOf(const app::Session& session, const app::LiveSheets& sheets, Beside beside)
{
    const bool lessons = beside == Beside::Lessons;
    if (session.display().presenting && session.microscope.isOpen())
        return lessons ? Mode::PresentingLessons : Mode::PresentingMicroscope;
    if (session.display().presenting)
        return Mode::Presenting;
    if (session.microscope.isOpen())
        return lessons ? Mode::Lessons : Mode::Microscope;
    return sheets.isOpen() ? Mode::Tiles : Mode::Editing;
}

Modes::Modes(app::Session& session, app::DrawnLine& drawn, Canvas& canvas, Parts parts)
    : session_(session), parts_(std::move(parts)),
      microscope_(session, drawn, canvas, parts_.centre),
      tiles_(session, parts_.sheets, canvas, parts_.centre), sheets_(parts_.centre, canvas),
      presenting_(parts_.window)
{
    connect(&session.microscope, &app::Microscope::openChanged, this, &Modes::followMicroscope);
    connect(&parts_.sheets, &app::LiveSheets::openChanged, this, &Modes::followSheets);
    connect(&microscope_, &MicroscopeMode::lessonsToggled, this, &Modes::followLessons);
    connect(&sheets_, &SheetPlace::changed, this, &Modes::followSheet);
}

void Modes::followMicroscope()
{
    const bool open = session_.microscope.isOpen();
    open ? microscope_.enter() : microscope_.leave();
    if (open)
        parts_.sheets.close();
    if (open && sheets_.sheet() && sheets_.sheet()->preview())
        sheets_.close();
    fit();
    if (!open)
        microscope_.returnFocus();
    emit changed();
}

/// Lessons that end with the microscope are followed by followMicroscope.
void Modes::followLessons()
{
    if (session_.microscope.isOpen())
        fit();
    emit changed();
}

/// A side sheet stands in the place of the panels, in every mode but Tiles, which have a column of
/// their own there.
void Modes::followSheet()
{
    if (sheets_.sheet())
        parts_.sheets.close();
    fit();
    parts_.centre.layOut();
    emit changed();
}

void Modes::followSheets()
{
    const bool open = parts_.sheets.isOpen();
    if (open) {
        tiles_.enter();
        sheets_.close();
        session_.microscope.close();
    }
    fit();
    if (!open && parts_.centre.showsCanvas())
        tiles_.returnFocus();
    emit changed();
}

void Modes::togglePresenting()
{
    parts_.sheets.close();
    const bool presenting = !session_.display().presenting;
    presenting ? presenting_.enter() : presenting_.leave();
    session_.changeDisplay(
        [presenting](app::Display& display) { display.presenting = presenting; });
    microscope_.remake();
    fit();
    emit changed();
}

Mode Modes::mode() const
{
    return modeOf(session_, parts_.sheets,
                  microscope_.showsLessons() ? Beside::Lessons : Beside::Nothing);
}

/// Shows the parts of the session's mode. The panels come back last, when the centre has its size.
void Modes::fit()
{
    ModeParts shown = partsOf(mode());
    const bool panels = shown.panels && !sheets_.sheet();
    const bool preview = sheets_.sheet() && sheets_.sheet()->preview();
    if (preview) // it has a bar of its own, and takes no tool
        shown.panels = shown.barAcross = shown.barAtSide = false;
    if (!panels)
        parts_.panels.hideAll();
    fitBars(shown);
    if (preview)
        parts_.centre.showPreview();
    else if (shown.tiles)
        parts_.centre.showTiles();
    else
        shown.microscope ? parts_.centre.showMicroscope() : parts_.centre.showCanvas();
    if (panels)
        parts_.panels.bringBack();
}

void Modes::fitBars(const ModeParts& shown)
{
    parts_.status.setVisible(shown.status);
    if (!barsOfEditing_) {
        barsOfEditing_.emplace();
        for (QToolBar* bar : parts_.bars)
            if (!bar->isHidden())
                barsOfEditing_->append(bar);
    }
    for (QToolBar* bar : *barsOfEditing_)
        bar->setVisible(bar->orientation() == Qt::Horizontal ? shown.barAcross : shown.barAtSide);
    if (shown.panels)
        barsOfEditing_.reset();
}

} // namespace ui

#include "moc_modes.cpp"

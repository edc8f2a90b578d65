// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/numbers.h"
#include "app/session/window_in_hand.h"
#include "ui/bars/status_bar.h"
#include "ui/editing/editing.h"
#include "ui/files/files.h"
#include "ui/look/text.h"
#include "ui/microscope/microscope_page.h"
#include "ui/tiles/tiles_page.h"
#include "ui/window/main_window.h"

#include <QSettings>

#include <utility>

// Connects the signals of session, files, canvas and microscope to the window.

namespace ui {

/// The chosen clip window, as far as texts and check marks of menu entries depend on it.
static auto windowInHand(const app::Session& session)
{
    return std::pair(app::needsInHand(session), session.windowNumber());
}

void MainWindow::connectSession()
{
    for (const auto signal : {&app::Session::displayChanged, &app::Session::selectionChanged,
                              &app::Session::fileChanged})
        connect(&session_, signal, this, &MainWindow::refreshActions);
    connect(&session_.document, &app::EditedDocument::changed, this, &MainWindow::refreshActions);
    connect(canvas_, &Canvas::toolChanged, this, &MainWindow::refreshActions); // Delete
    connect(&session_.history, &app::History::indexChanged, this, &MainWindow::refreshActions);
    connect(&session_, &app::Session::previewChanged, this,
            [this, before = windowInHand(session_)]() mutable {
                // The names of algorithms say what they can clip.
                if (const auto now = windowInHand(session_); std::exchange(before, now) != now)
                    refreshActions();
            });
    connect(&session_.nodes, &app::NodeEditing::changed, this, &MainWindow::refreshActions);
    connect(&session_.entered, &app::EnteredGroup::changed, this, &MainWindow::refreshActions);
    connect(&session_.course, &app::Course::changed, this, [this, before = false]() mutable {
        if (const bool now = session_.course.lesson(); std::exchange(before, now) != now)
            refreshActions();
    });
    connect(&session_.history, &app::History::cleanChanged, this, &MainWindow::showTitle);
    connect(&session_.history, &app::History::indexChanged, strip_, &MessageStrip::closeDone);
    connect(status_, &StatusBar::warningWanted, this, [this](const QString& sentence) {
        tell({Message::Kind::Warning, sentence});
    });
    connect(status_, &StatusBar::timed, this, [this](const QString& clip, std::size_t differing) {
        panels_.showResult(session_, clip, differing);
    });
    connect(&session_, &app::Session::refused, this, [this](const QString& sentence) {
        tell({Message::Kind::Warning, sentence});
        // The next step shows that it is settled, or no longer wanted.
        const auto withdraw = [this, sentence] {
            if (message() == sentence)
                tell({});
        };
        connect(&session_.history, &app::History::indexChanged, strip_, withdraw,
                Qt::SingleShotConnection);
    });
}

void MainWindow::warn(const QString& sentence)
{
    const QString before = std::exchange(warning_, sentence);
    status_->warn(sentence);
    if (sentence != before && (before.isEmpty() || message() == before))
        tell({Message::Kind::Warning, sentence});
}

void MainWindow::connectFiles()
{
    connect(files_.get(), &Files::documentWanted, canvas_, &Canvas::endGesture);
    connect(files_.get(), &Files::documentWanted, &sheets_, &app::LiveSheets::keep);
    connect(files_.get(), &Files::told, this, &MainWindow::tell);
    connect(files_.get(), &Files::nameChanged, this, &MainWindow::showTitle);
}

void MainWindow::rememberSnapping()
{
    canvas_->setSnapping(app::SnapTo::fromText(QSettings().value("snapKinds").toString()));
    canvas_->switchSnapping(QSettings().value("snap", true).toBool());
    connect(canvas_, &Canvas::snappingChanged, this, [this] {
        QSettings().setValue("snapKinds", canvas_->snapping().text());
        QSettings().setValue("snap", canvas_->snaps());
        refreshActions();
    });
}

void MainWindow::rememberCapsule()
{
    canvas_->setCapsuleHome(app::capsuleHomeOf(QSettings().value("capsule").toString()));
    connect(canvas_, &Canvas::capsuleSwitched, this, [this] {
        const auto home = std::size_t(canvas_->capsuleHome());
        QSettings().setValue("capsule", app::latin(app::capsuleHomes()[home].key));
        refreshActions();
    });
}

void MainWindow::rememberGrid()
{
    session_.changeDisplay([](app::Display& display) {
        display.grid = app::Grid::fromText(QSettings().value("grid").toString());
    });
    connect(&session_, &app::Session::displayChanged, this,
            [this, saved = session_.display().grid]() mutable {
                if (session_.display().grid == saved)
                    return;
                saved = session_.display().grid;
                QSettings().setValue("grid", saved.text());
            });
}

void MainWindow::rememberPaper()
{
    session_.changeDisplay(
        [](app::Display& display) { display.darkPaper = QSettings().value("darkPaper").toBool(); });
    connect(&session_, &app::Session::displayChanged, this,
            [this, saved = session_.display().darkPaper]() mutable {
                if (session_.display().darkPaper == saved)
                    return;
                saved = session_.display().darkPaper;
                QSettings().setValue("darkPaper", saved);
            });
}

// The message is shown once per drawing, and after the command's own message, which would replace
// it.
void MainWindow::limitHistory()
{
    session_.history.setLimit(bytesOf(undoMegabytes()));
    const auto sayWhy = [this] {
        tell({Message::Kind::Warning,
              Text::tr(
                  "The oldest steps can no longer be undone: undo may use at most %1 MB of memory "
                  "(File, Settings…). Save a copy if you may need this state again.")
                  .arg(app::countText(session_.history.limit() / bytesOf(1)))});
    };
    connect(&session_.history, &app::History::forgot, this, [this, sayWhy](int steps) {
        if (steps == session_.history.forgotten())
            QMetaObject::invokeMethod(this, sayWhy, Qt::QueuedConnection);
    });
}

void MainWindow::connectMicroscope(MicroscopePage* page)
{
    connect(page, &MicroscopePage::refused, this, [this](const QString& sentence) {
        tell({Message::Kind::Warning, sentence});
    });
    connect(page, &MicroscopePage::pointerMoved, status_, &StatusBar::showPoint);
    connect(page, &MicroscopePage::hinted, status_, &StatusBar::showHint);
    connect(page, &MicroscopePage::aboutWanted, this,
            [this](const clipping::Algorithm* algorithm) { emit explanationWanted(*algorithm); });
    connect(page, &MicroscopePage::exportWanted, this, &MainWindow::stepsExportWanted);
}

void MainWindow::connectTiles(TilesPage* page)
{
    connect(page, &TilesPage::hinted, status_, &StatusBar::showHint);
    connect(&page->view(), &TilesView::frameShown, status_, &StatusBar::note);
    connect(&sheets_, &app::LiveSheets::changed, this, &MainWindow::showTilesInStatus);
    connect(page, &TilesPage::exportWanted, this, [this] {
        files_->exportSheets(sheets_.sheets(), app::patternOf(sheets_.settings(), sheets_.title()));
    });
}

void MainWindow::showTilesInStatus()
{
    if (!sheets_.isOpen())
        return status_->setSummary({});
    const auto& tiling = sheets_.tiling();
    const int written = tiling ? tiling.value->written() : 0;
    const QString paper = tiling ? app::paperText(sheets_.settings(), *tiling.value) : QString();
    status_->setSummary(written == 1 ? Text::tr("1 sheet, %1").arg(paper)
                                     : Text::tr("%1 sheets, %2").arg(written).arg(paper));
}

void MainWindow::showTitle()
{
    sheets_.setTitle(files_->baseName().replace(u'/', u'-'));
    setWindowTitle(Text::tr("%1[*] – Clearcut").arg(files_->name()));
    setWindowFilePath(session_.path());
    setWindowModified(!session_.history.isClean());
}

} // namespace ui

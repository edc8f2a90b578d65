// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/files/files.h"
#include "ui/look/look.h"
#include "ui/menus/actions.h"
#include "ui/window/main_window.h"

#include <QAction>
#include <QDoubleSpinBox>
#include <QFile>
#include <QSettings>
#include <QTemporaryDir>
#include <QTest>

// A main window with settings of its own and with prepared answers in place of dialogs.

namespace ui {

class PreparedAnswers : public Questions {
public:
    explicit PreparedAnswers(QWidget& window) : Questions(window) {}

    QString open, save, proposed;
    QString directory; ///< for several files; empty: cancelled
    Answer answer = Answer::Cancel;
    bool asNewFile = false, overwrite = false;
    QStringList existing; ///< files that a question about overwriting named
    int asked = 0;        ///< number of questions about unsaved changes

    QString fileToOpen(const QString&) override { return open; }
    QString fileToWrite(const QString&, const QString& proposal, const QString&,
                        const QString&) override
    {
        proposed = proposal;
        return save;
    }
    QString filesToWrite(const QString&, const QString& proposal, const QString&,
                         const QString&) override
    {
        proposed = proposal;
        return save;
    }
    QString folderToWrite(const QString&, const QString&) override { return directory; }
    QStringList lessons; ///< files; empty: cancelled
    QStringList lessonsToOpen(const QString&) override { return lessons; }
    QString lessonFolderToOpen(const QString&) override { return directory; }
    bool hasPrinter() override { return false; }
    int askedAboutFiles = 0; ///< number of questions about overwriting several files
    bool overwriteFiles(const QStringList& files, int) override
    {
        ++askedAboutFiles;
        existing = files;
        return overwrite;
    }
    void saveChanges(const QString&, std::function<void(Answer)> answered) override
    {
        ++asked;
        answered(answer);
    }
    Leftover leftover = Leftover::Later;
    void aboutLeftover(const app::Leftover&, std::size_t,
                       std::function<void(Leftover)> answered) override
    {
        answered(leftover);
    }
    bool saveAsNewFile(const std::vector<app::Loss>&) override { return asNewFile; }
    void showLosses(const QString&, const std::vector<app::Loss>&) override {}
    ChangedFile changedFile = ChangedFile::Cancel;
    ChangedFile aboutChangedFile(const QString&) override { return changedFile; }
};

/// A window as the editor makes it.
inline std::unique_ptr<MainWindow> windowWithMenus()
{
    auto window = std::make_unique<MainWindow>(Backend::Raster);
    addMenus(*window);
    return window;
}

/// Waits until a panel has its final size, on which those beside it have a say.
inline void waitForFinalSize(const QWidget& panel)
{
    for (QSize size; size != panel.size();) {
        size = panel.size();
        QTest::qWait(150);
    }
}

/// Settings and a home in a folder of the test, and the light theme.
inline void liveIn(const QTemporaryDir& folder)
{
    qputenv("HOME", folder.path().toUtf8()); // new drawings are exported to it
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder.path());
    QCoreApplication::setOrganizationName("Clearcut");
    QCoreApplication::setApplicationName("Clearcut");
    applyTheme(*qApp, Theme::Light);
}

class TestWindow {
public:
    TestWindow()
    {
        liveIn(folder);
        window = windowWithMenus();
        auto prepared = std::make_unique<PreparedAnswers>(*window);
        answers = prepared.get();
        window->setQuestions(std::move(prepared));
        window->resize(1280, 800);
        window->session().course.setSeed(0); // the lessons' lines as their files have them
        window->session().practice.setSeed(5);
    }

    void show()
    {
        window->show();
        QVERIFY(QTest::qWaitForWindowExposed(window.get()));
        window->activateWindow();
        window->canvas().setFocus();
    }
    /// Opens a file, and waits until it is shown.
    void open(const QString& file) const
    {
        window->files().open(file);
        window->files().wait();
    }
    /// Chooses a command, and waits until no file is read or written any more.
    void run(const char* command) const
    {
        action(command)->trigger();
        window->files().wait();
    }
    /// Saves, and waits for the answer.
    bool saved(void (Files::*save)(Files::Answer) = &Files::save) const
    {
        std::optional<bool> answer;
        (window->files().*save)([&](bool yes) { answer = yes; });
        window->files().wait();
        return answer.value();
    }
    QAction* action(const char* name) const { return window->findChild<QAction*>(name); }
    QString path(const char* name) const { return folder.filePath(name); }
    QWidget* drawingArea() const
    {
        QWidget* proxy = window->canvas().focusProxy();
        return proxy ? proxy : &window->canvas();
    }
    /// A drawing of two lines: one across the window (25,25)-(75,75), one far from it.
    QString file(const QString& name, const QByteArray& content) const
    {
        QFile out(folder.filePath(name));
        [[maybe_unused]] const bool open = out.open(QIODevice::WriteOnly);
        out.write(content);
        return out.fileName();
    }
    QString twoLines() const
    {
        return file("two.svg",
                    "<svg xmlns='http://www.w3.org/2000/svg' width='100mm' height='100mm' "
                    "viewBox='0 0 100 100' xmlns:clearcut='urn:clearcut:1'><metadata>"
                    "<clearcut:window xmin='0' ymin='0' xmax='100' ymax='100'/></metadata>"
                    "<path d='M0 50H100M0 5H10' stroke='#000' "
                    "fill='none'/></svg>");
    }

    QTemporaryDir folder;
    std::unique_ptr<MainWindow> window;
    PreparedAnswers* answers = nullptr;
};

} // namespace ui

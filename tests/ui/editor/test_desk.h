// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/move_objects.h"
#include "ui/editor/desk.h"
#include "ui/files/files.h"

#include <QDir>
#include <QTabBar>

#include <map>

#include "tests/ui/test_window.h"

namespace ui {

/// The program's window with several drawings.
struct TestDesk {
    /// Unprepared: it asks in its strips.
    enum class Answers : std::uint8_t { Prepared, Asked };
    explicit TestDesk(Answers kind = Answers::Prepared)
    {
        liveIn(folder);
        desk = std::make_unique<Desk>(Backend::Raster);
        if (kind == Answers::Prepared) {
            QObject::connect(desk.get(), &Desk::made,
                             [this](MainWindow& window) { prepare(window); });
            prepare(desk->current());
        }
        desk->resize(1280, 800);
        static_cast<QWidget&>(*desk).show();
        [[maybe_unused]] const bool shown = QTest::qWaitForWindowExposed(desk.get());
        desk->activateWindow();
    }
    void prepare(MainWindow& window)
    {
        auto prepared = std::make_unique<PreparedAnswers>(window);
        answers[&window] = prepared.get();
        window.setQuestions(std::move(prepared));
    }
    PreparedAnswers& answersOf(MainWindow& window) { return *answers[&window]; }
    QString file(const QString& name, double x = 5) const
    {
        QFile out(folder.filePath(name));
        QDir().mkpath(QFileInfo(out).path());
        [[maybe_unused]] const bool open = out.open(QIODevice::WriteOnly);
        out.write(QStringLiteral("<svg xmlns='http://www.w3.org/2000/svg' width='100mm' "
                                 "height='100mm' viewBox='0 0 100 100'><path d='M0 50H100M0 5H%1' "
                                 "stroke='#000' fill='none'/></svg>")
                      .arg(x)
                      .toUtf8());
        return out.fileName();
    }
    void open(const QString& path) const
    {
        desk->current().files().open(path);
        for (int i = 0; i < desk->count(); ++i)
            if (desk->isRead(i))
                desk->at(i).files().wait();
    }
    QAction* action(const char* name) const
    {
        return desk->current().findChild<QAction*>(name, Qt::FindDirectChildrenOnly);
    }
    void run(const char* command) const
    {
        action(command)->trigger();
        desk->current().files().wait();
    }
    static void edit(MainWindow& window)
    {
        app::Session& session = window.session();
        session.history.push(new app::MoveObjects(session.document, {0}, {1, 0}));
    }
    QTabBar& tabs() const { return *desk->current().findChild<QTabBar*>("drawing-tabs"); }
    QStringList names() const
    {
        QStringList all;
        for (int i = 0; i < tabs().count(); ++i)
            all << tabs().tabText(i);
        return all;
    }

    QTemporaryDir folder;
    std::map<MainWindow*, PreparedAnswers*> answers;
    std::unique_ptr<Desk> desk;
};

} // namespace ui

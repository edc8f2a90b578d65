// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/document/window_operations.h"
#include "app/drawing/transformation.h"
#include "app/session/window_steps.h"
#include "ui/menus/actions.h"
#include "ui/sheets/command_keys.h"
#include "ui/tools/tool.h"

#include <QMenu>
#include <QMenuBar>
#include <QTextBrowser>
#include <QTextTable>

#include "tests/content_of.h"
#include "tests/not_empty.h"
#include "tests/test_class.h"
#include "tests/ui/test_window.h"

// The menus of the window against the rows of their catalogues.

namespace ui::menus_menus_test {

class MenusTest : public QObject {
    Q_OBJECT

    /// The names of a menu's commands, the titles of its submenus, and "-" for a separator.
    static QStringList entriesOf(const QMenu& menu)
    {
        QStringList entries;
        for (const QAction* action : menu.actions())
            entries << (action->isSeparator() ? QStringLiteral("-")
                        : action->menu()      ? action->text()
                                              : action->objectName());
        return entries;
    }

    static QStringList wantedOf(const MenuInfo& info)
    {
        QStringList entries;
        for (const ActionInfo& row : info.rows)
            if (row.paletteOnly)
                continue;
            else if (row.text.isEmpty() && row.submenu.isEmpty())
                entries << QStringLiteral("-");
            else if (row.submenu.isEmpty())
                entries << (row.fill           ? row.text
                            : row.tool.empty() ? app::latin(row.key)
                                               : QStringLiteral("tool-") + app::latin(row.tool));
            else if (!entries.contains(row.submenu))
                entries << row.submenu;
        return entries;
    }

    static const QMenu* menuOf(const TestWindow& t, const QString& title)
    {
        for (const QAction* top : t.window->menuBar()->actions())
            if (top->text() == title)
                return top->menu();
        return nullptr;
    }

    /// Entries of a menu and its submenus that share their underlined letter with another entry.
    static QStringList clashesIn(const QMenu& menu)
    {
        QStringList clashes;
        QSet<QKeySequence> taken;
        for (const QAction* entry : menu.actions()) {
            const QKeySequence letter = QKeySequence::mnemonic(entry->text());
            if (!letter.isEmpty() && taken.contains(letter))
                clashes << menu.title() + u'/' + entry->text();
            taken.insert(letter);
            if (entry->menu())
                clashes << clashesIn(*entry->menu());
        }
        return clashes;
    }

private slots:
    void theKeysOfAllMenusAreInOneColumn()
    {
        TestWindow t;
        t.show();
        t.run("shortcuts");
        const auto* page = t.window->findChild<QTextBrowser*>();
        QVERIFY(page && page->toPlainText().contains("Ctrl+Shift+V"));
        int tables = 0;
        for (const QTextFrame* frame : page->document()->rootFrame()->childFrames())
            tables += qobject_cast<const QTextTable*>(frame) != nullptr;
        QCOMPARE(tables, 1);
    }
    /// Keys that the canvas itself understands are shown beside their commands.
    void keysOfTheChosenWindowAreShown()
    {
        TestWindow t;
        t.show();
        app::Session& session = t.window->session();
        const auto operation = [&] { return session.now().windows().list.back().operation; };
        for (const app::WindowOperationInfo& each : app::windowOperations())
            QCOMPARE(t.action(each.key.data())->shortcut(), QKeySequence(each.letter));
        for (const double right : {30, 40})
            app::addWindow(session, {.shape = app::RectangleShape{{{10, 10}, {right, 40}}}});
        const int before = session.history.index();
        t.window->canvas().setTool("line");
        QTest::keyClick(t.drawingArea(), '-'); // a number begins
        QTest::keyClick(t.drawingArea(), Qt::Key_Escape);
        QCOMPARE(session.history.index(), before);
        t.window->canvas().setTool("window");
        t.window->canvas().setFocus();
        QTest::keyClick(t.drawingArea(), '-');
        QCOMPARE(operation(), app::WindowOperation::CutOut);
        QCOMPARE(session.history.index(), before + 1); // once
        t.run("shortcuts");
        const QString page = t.window->findChild<QTextBrowser*>()->toPlainText();
        QVERIFY(page.contains("Keep outside\nX"));
        QVERIFY(page.contains("Cut out of those above\n-"));
    }
    /// Sentences name the keys of commands in braces.
    void aNameIsNotReadAsACommand()
    {
        TestWindow t;
        app::Session& session = t.window->session();
        const QString name = QStringLiteral("{move} ({zzz})");
        app::addWindow(session, {.name = name, .shape = app::RectangleShape{{{10, 10}, {30, 40}}}});
        const QString why = "No clip window is above " + name + ".";
        QCOMPARE(t.action("window-intersects")->statusTip(), why);
        app::setWindowOperation(session, 0, app::WindowOperation::Intersect);
        QCOMPARE(t.window->message(), why);
        t.window->canvas().transform(app::transformations().front());
        QVERIFY2(t.window->message().contains("(V)"), qPrintable(t.window->message()));
    }
    void noTwoEntriesOfAMenuHaveTheSameLetter()
    {
        const TestWindow t;
        QStringList clashes;
        for (const QAction* top : notEmpty(t.window->menuBar()->actions()))
            clashes << clashesIn(*top->menu());
        QVERIFY2(clashes.isEmpty(), qPrintable(clashes.join(", ")));
    }

    void everyMenuHasTheEntriesOfItsRows()
    {
        const TestWindow t;
        for (const MenuInfo& info : notEmpty(menus())) {
            const QMenu* menu = menuOf(t, info.title);
            QVERIFY2(menu, qPrintable(info.title));
            const QStringList wanted = wantedOf(info);
            QCOMPARE(entriesOf(*menu).mid(menu->actions().size() - wanted.size()), wanted);
            QVERIFY2(info.begin || wanted.size() == menu->actions().size(), qPrintable(info.title));
        }
    }

    void everyRowIsACommandOrFillsASubmenu()
    {
        for (const MenuInfo& info : notEmpty(menus()))
            for (const ActionInfo& row : info.rows)
                QCOMPARE(int(row.run != nullptr) + int(row.show != nullptr)
                             + int(row.fill != nullptr) + int(!row.tool.empty()),
                         int(!row.text.isEmpty()));
    }

    void undoAndRedoStandAboveTheRowsOfEdit()
    {
        const TestWindow t;
        QCOMPARE(entriesOf(*menuOf(t, "&Edit")).mid(0, 4),
                 QStringList({"undo", "redo", "-", "cut"}));
    }

    void menusAreShort()
    {
        const TestWindow t;
        qsizetype all = 0;
        for (const QAction* top : notEmpty(t.window->menuBar()->actions())) {
            QStringList entries = entriesOf(*top->menu());
            entries.removeAll(QStringLiteral("-"));
            QVERIFY2(entries.size() <= 12, qPrintable(top->text()));
            all += entries.size();
        }
        QVERIFY2(all <= 85, qPrintable(QString::number(all)));
    }

    void aSampleIsOpenedByTheMenu()
    {
        const TestWindow t;
        const auto all = app::samples();
        for (const app::Sample& sample : notEmpty(all)) {
            t.run(qPrintable(QStringLiteral("sample-") + sample.key));
            QCOMPARE(t.window->files().sample(), sample.key);
            QVERIFY(t.window->session().scene.lines().size() > 0);
        }
        QCOMPARE(t.answers->asked, 0); // they are not changed
        const QMenu* samples = menuOf(t, "&File")->actions().at(3)->menu();
        QVERIFY(samples && samples->actions().size() == qsizetype(all.size()));
    }
    /// But for those that hold files and layers.
    void submenusAreShort()
    {
        const TestWindow t;
        int looked = 0;
        for (const QAction* top : notEmpty(t.window->menuBar()->actions()))
            for (const QAction* entry : top->menu()->actions()) {
                if (!entry->menu())
                    continue;
                QStringList entries = entriesOf(*entry->menu());
                entries.removeAll(QStringLiteral("-"));
                QVERIFY2(entries.size() <= 12, qPrintable(entry->text()));
                ++looked;
            }
        QVERIFY(looked > 15);
    }

    /// A command that is wanted no more is taken from the list, and a new one is added to it: its
    /// name stands in settings, with its keys.
    void theListOfCommandsIsComplete()
    {
        const TestWindow t;
        QStringList found;
        for (const app::KeyedCommand& command : CommandKeys::of(*t.window).table().commands())
            if (!command.key.isEmpty())
                found << command.key;
        const QStringList wanted =
            QString::fromUtf8(contentOf(QStringLiteral(SOURCE_DIR "/tests/ui/menus/commands.txt")))
                .split(u'\n', Qt::SkipEmptyParts);
        const auto without = [](QStringList names, const QStringList& others) {
            for (const QString& name : notEmpty(others))
                names.removeAll(name);
            return names.join(u' ');
        };
        QCOMPARE(without(wanted, found), QString()); // lost
        QCOMPARE(without(found, wanted), QString()); // not in the list
    }

    void commandsWithoutAnEntryHaveKeysAndReasons()
    {
        TestWindow t;
        t.show();
        QAction* action = t.action("to-page");
        QVERIFY(action && action->isCheckable());
        action->setShortcut(QKeySequence("F10"));
        QTest::keyClick(t.drawingArea(), Qt::Key_F10);
        QVERIFY(action->isChecked());
        QVERIFY(!t.action("delete-nodes")->statusTip().isEmpty());
    }

    void cutsSayWhyTheyAreDisabled()
    {
        TestWindow t;
        t.run("new");
        for (const char* cut : {"crop", "cut-out", "split", "occlude", "tiles"})
            QCOMPARE(t.action(cut)->statusTip(), QStringLiteral("The drawing is empty."));
        t.open(t.twoLines());
        t.run("remove-window");
        for (const char* cut : {"crop", "cut-out", "split"})
            QCOMPARE(t.action(cut)->statusTip(),
                     QStringLiteral("No clip window is visible. Draw one first (W)."));
        QCOMPARE(t.action("occlude")->statusTip(), QString());
        QVERIFY(t.action("occlude")->isEnabled());
    }

    void cutEdgesAreChosenInTheMenuAndInThePanel()
    {
        TestWindow t;
        t.show();
        t.open(t.twoLines());
        const auto cutting = [&t] { return t.window->session().display().cutting; };
        t.run("close-cut-areas");
        t.run("cut-hidden");
        QVERIFY(cutting().closeAreas && cutting().cutHidden);
        QVERIFY(t.action("cut-hidden")->isChecked());
        t.run("drop-pieces");
        const auto* field = t.window->findChild<QWidget*>("least-piece");
        QTRY_VERIFY(field->isVisible() && field->hasFocus());
        t.window = windowWithMenus(); // remembered
        QVERIFY(cutting().closeAreas && cutting().cutHidden);
        t.run("close-cut-areas");
        t.run("cut-hidden");
        QVERIFY(!cutting().closeAreas && !cutting().cutHidden);
    }

    /// Each is in one menu.
    void everyToolIsInAMenu()
    {
        QStringList wanted, found;
        for (const ToolInfo& tool : notEmpty(tools()))
            wanted << app::latin(tool.key);
        for (const MenuInfo& info : notEmpty(menus()))
            for (const ActionInfo& row : info.rows)
                if (!row.tool.empty())
                    found << app::latin(row.tool);
        wanted.sort();
        found.sort();
        QCOMPARE(found, wanted);
    }

    void theCommandsOfPanesAreInASubmenu()
    {
        const TestWindow t;
        const QMenu* panes = menuOf(t, "&View")->actions().at(1)->menu();
        QVERIFY(panes);
        QCOMPARE(panes->title(), "&Panes");
        QCOMPARE(entriesOf(*panes), QStringList({"panes-1", "panes-2", "panes-4", "panes-all",
                                                 "next-pane", "previous-pane", "close-pane"}));
    }

    void theStepsOfNodesAreInASubmenuInGroups()
    {
        const TestWindow t;
        const auto entriesOfObject = menuOf(t, "&Object")->actions();
        const QMenu* path = entriesOfObject.at(entriesOfObject.size() - 2)->menu();
        QVERIFY(path && path->toolTipsVisible());
        QStringList wanted;
        for (const app::NodeStep& step : notEmpty(app::nodeSteps()))
            if (step.key != "delete-nodes") // Edit > Delete
                wanted << app::latin(step.key);
        wanted << QStringLiteral("stroke-outline");
        QStringList entries = entriesOf(*path);
        QCOMPARE(entries.mid(0, 4), wanted.mid(0, 3) << QStringLiteral("-"));
        entries.removeAll(QStringLiteral("-"));
        QCOMPARE(entries, wanted); // each in the menu
    }

    void aLetterInAnOpenMenuChoosesAnEntryNotATool()
    {
        TestWindow t;
        t.show();
        QTest::keyClick(t.drawingArea(), Qt::Key_V, Qt::AltModifier);
        auto* menu = qobject_cast<QMenu*>(QApplication::activePopupWidget());
        QVERIFY(menu && menu == menuOf(t, "&View"));
        QTest::keyClick(menu, Qt::Key_D); // "Grid"; on the canvas, the pen
        QTRY_VERIFY(QApplication::activePopupWidget() != menu);
        QTest::keyClick(QApplication::activePopupWidget(), Qt::Key_I);
        QVERIFY(t.action("grid-isometric")->isChecked());
        QVERIFY(t.action("tool-select")->isChecked());
        QTest::keyClick(t.drawingArea(), Qt::Key_D); // the menu is closed
        QVERIFY(t.action("tool-pen")->isChecked());
    }
};

} // namespace ui::menus_menus_test

TEST_CLASS(ui::menus_menus_test::MenusTest, Widgets)
#include "tests/ui/menus/menus_test.moc"

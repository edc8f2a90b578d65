// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/text.h"
#include "app/teaching/manual.h"
#include "ui/docks/layers_panel.h"
#include "ui/explanation/explanation_window.h"
#include "ui/explanation/page_view.h"
#include "ui/sheets/command_keys.h"
#include "ui/sheets/sheets.h"
#include "ui/tools/tool.h"

#include <QApplication>
#include <QLineEdit>
#include <QListView>
#include <QMenuBar>
#include <QRegularExpression>

#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace menus_manual_test {

// The manual's keys and menus against those of the window.

using namespace ui;

namespace {

QString plain(QString text)
{
    return text.remove('&').remove(QStringLiteral("…")).section('\t', 0, 0).trimmed();
}

/// "Clip", "Clip > Crop to windows" and so on, of the whole menu bar.
void addPaths(const QList<QAction*>& actions, const QString& before, QSet<QString>& paths)
{
    for (QAction* action : actions) {
        if (action->isSeparator())
            continue;
        const QString path = before + plain(action->text());
        paths << path;
        if (QMenu* menu = action->menu()) {
            emit menu->aboutToShow(); // some are filled then
            addPaths(menu->actions(), path + QStringLiteral(" > "), paths);
        }
    }
}

/// What keys do in gestures, fields and lists, where no menu has them.
QSet<QString> keysOfGestures()
{
    return {"Shift",   "Alt",       "Ctrl",        "Esc",    "Enter",  "Tab",  "Backspace",
            "Space",   "Up",        "Down",        "Left",   "Right",  "X",    "Y",
            "C",       "P",         "Shift+Enter", "0",      "1",      "9",    "Ctrl+Enter",
            "Ctrl+Up", "Ctrl+Down", "Shift+Tab",   "Ctrl+B", "Ctrl+I", "Menu", "Shift+F10"};
}

QString allPages()
{
    QString text;
    for (const QString& topic : app::manualTopics())
        text += app::manualPage(topic)->markdown + '\n';
    return text;
}

} // namespace

class ManualTest : public QObject {
    Q_OBJECT

private slots:
    void everyMenuThatIsNamedExists()
    {
        TestWindow t;
        QSet<QString> paths;
        addPaths(t.window->menuBar()->actions(), {}, paths);
        QVERIFY(paths.size() > 80);
        static const QRegularExpression named(
            QStringLiteral("\\*([A-Z][^*]+)\\*((?:\\s>\\s\\*[^*]+\\*)+)"));
        QStringList missing;
        int found = 0;
        for (auto all = named.globalMatch(allPages()); all.hasNext();) {
            const QString path = plain(all.next().captured().remove('*').simplified());
            ++found;
            if (!paths.contains(path))
                missing << path;
        }
        QVERIFY(found > 15);
        QVERIFY2(missing.isEmpty(), qPrintable(missing.join("; ")));
    }

    void everyKeyThatIsNamedExists()
    {
        TestWindow t;
        QSet<QString> known = keysOfGestures();
        for (const QAction* action : t.window->findChildren<QAction*>())
            for (const QKeySequence& keys : action->shortcuts())
                known << keys.toString(QKeySequence::PortableText);
        static const QRegularExpression bold(QStringLiteral("\\*\\*([^*]+)\\*\\*"));
        static const QRegularExpression isKey(
            QStringLiteral("^((Ctrl|Shift|Alt)\\+)*([A-Z0-9?]|F\\d+|[A-Z][a-z]+([A-Z][a-z]+)?)$"));
        QStringList missing;
        int found = 0;
        for (auto all = bold.globalMatch(allPages()); all.hasNext();) {
            const QString keys = all.next().captured(1);
            if (!isKey.match(keys).hasMatch())
                continue;
            ++found;
            if (!known.contains(keys))
                missing << keys;
        }
        QVERIFY(found > 100);
        missing.removeDuplicates();
        QVERIFY2(missing.isEmpty(), qPrintable(missing.join("; ")));
    }

    // Commands, tools, panels and sheets: all are commands of the window.
    void everyCommandHasOnePage()
    {
        TestWindow t;
        QSet<QString> known;
        QStringList without;
        for (const app::KeyedCommand& command : CommandKeys::of(*t.window).table().commands()) {
            known << command.key;
            if (!command.key.isEmpty() && app::topicExplaining(command.key).isEmpty())
                without << command.key;
        }
        QVERIFY(known.size() > 200);
        QVERIFY2(without.isEmpty(), qPrintable(without.join(' ')));
        QSet<QString> explained;
        for (const QString& topic : app::manualTopics()) {
            const auto page = app::manualPage(topic);
            for (const QString& command : page->explains) {
                QVERIFY2(known.contains(command), qPrintable(topic + ": " + command));
                QVERIFY2(!explained.contains(command), qPrintable(command));
                explained << command;
            }
        }
        for (const SheetInfo& sheet : sheets())
            QVERIFY(!app::topicExplaining(app::latin(sheet.key)).isEmpty());
        for (const Dock* dock : t.window->findChildren<Dock*>())
            if (dock->objectName() != "start")
                QVERIFY2(!app::topicExplaining("panel-" + dock->objectName()).isEmpty(),
                         qPrintable(dock->objectName()));
    }

    void f1ExplainsWhatIsInHand()
    {
        TestWindow t;
        t.show();
        const auto page = [&] { return t.window->findChild<ExplanationWindow*>()->page().topic(); };
        const auto help = [&] { t.action("help")->trigger(); };
        t.window->canvas().setTool("pen");
        t.window->canvas().setFocus();
        QTest::keyClick(t.drawingArea(), Qt::Key_F1);
        QCOMPARE(page(), QStringLiteral("curves"));
        t.window->canvas().setTool("text"); // it follows
        QCOMPARE(page(), QStringLiteral("text"));
        t.window->canvas().setTool("window");
        QCOMPARE(page(), QStringLiteral("draw-windows"));
        emit t.window->findChild<ExplanationWindow*>()->page().anchorClicked(QUrl("numbers.md"));
        t.window->canvas().setTool("line"); // another page was chosen
        QCOMPARE(page(), QStringLiteral("numbers"));
        t.window->activateWindow();
        t.window->raisePanel("layers");
        t.window->findChild<LayersPanel*>()->findChild<QLineEdit*>()->setFocus();
        help();
        QCOMPARE(page(), QStringLiteral("layers"));
        t.action("settings")->trigger();
        help();
        QCOMPARE(page(), QStringLiteral("settings"));
        t.window->closeSheet();
        t.action("microscope")->trigger();
        help();
        QCOMPARE(page(), QStringLiteral("microscope"));
        t.action("lessons")->trigger();
        help();
        QCOMPARE(page(), QStringLiteral("lessons"));
    }

    void everyToolsPageIsShown()
    {
        TestWindow t;
        for (const ToolInfo& tool : tools()) {
            t.window->canvas().setTool(tool.key);
            t.window->canvas().setFocus();
            t.action("help")->trigger();
            const auto& page = t.window->findChild<ExplanationWindow*>()->page();
            QVERIFY2(!page.topic().isEmpty(), tool.key.data());
            QVERIFY2(page.toPlainText().contains(tool.name), tool.key.data());
        }
    }

    void theContentsLeadOnAndFindPages()
    {
        TestWindow t;
        t.action("help")->trigger();
        auto* reader = t.window->findChild<ExplanationWindow*>();
        QVERIFY(reader && reader->isVisible());
        emit reader->page().anchorClicked(QUrl("snapping.md"));
        QCOMPARE(reader->page().topic(), QStringLiteral("snapping"));
        QVERIFY(reader->windowTitle().contains(app::manualPage("snapping")->title));
        auto* list = reader->findChild<QListView*>("help-pages");
        QCOMPARE(list->currentIndex().data().toString(), app::manualPage("snapping")->title);
        auto* field = reader->findChild<QLineEdit*>("search-help");
        QTest::keyClicks(field, "Ctrl+E");
        QVERIFY(list->model()->rowCount() > 0);
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(reader->page().topic(), QStringLiteral("export"));
        QTest::keyClick(field, Qt::Key_Escape);
        QVERIFY(reader->isVisible() && field->text().isEmpty());
        QCOMPARE(list->currentIndex().data().toString(), app::manualPage("export")->title);
        QTest::keyClicks(field, "xyzzy");
        QCOMPARE(list->model()->rowCount(), 1); // says that there is none
        QTest::keyClick(field, Qt::Key_Return);
        QCOMPARE(reader->page().topic(), QStringLiteral("export"));
        t.action("about-algorithm")->trigger();
        QVERIFY(reader->page().algorithm());
    }

    void f1WorksInOtherWindows()
    {
        TestWindow t;
        for (const char* command : {"reproduce-paper", "hard-cases", "judge"}) {
            t.action(command)->trigger();
            QWidget* other = QApplication::activeWindow();
            QTRY_VERIFY((other = QApplication::activeWindow()) != t.window.get() && other);
            QTest::keyClick(other, Qt::Key_F1);
            auto* reader = t.window->findChild<ExplanationWindow*>();
            QVERIFY(reader && reader->isVisible());
            QCOMPARE(reader->page().topic(), app::topicExplaining(command));
            reader->close();
            other->close();
        }
    }

    void aPageIsSavedWithItsPictures()
    {
        TestWindow t;
        PageView page;
        page.showManual("workspaces");
        QVERIFY(!page.saveAsPdf(t.path("page.pdf")).has_value());
        QVERIFY(QFileInfo(t.path("page.pdf")).size() > 20'000);
    }
};

} // namespace menus_manual_test

TEST_CLASS(menus_manual_test::ManualTest, Widgets)
#include "tests/ui/menus/manual_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/manual.h"
#include "ui/explanation/explanation_window.h"
#include "ui/explanation/page_view.h"
#include "ui/tools/tool.h"

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

    void theMenuOpensTheIndexAndLinksLeadOn()
    {
        TestWindow t;
        t.window->findChild<QAction*>("manual")->trigger();
        auto* reader = t.window->findChild<ExplanationWindow*>();
        QVERIFY(reader && reader->isVisible());
        QCOMPARE(reader->page().topic(), app::manualIndex);
        QVERIFY(reader->page().toPlainText().contains("Snapping"));
        QVERIFY(!reader->findChild<QListView*>()->isVisible()); // that of the algorithms
        emit reader->page().anchorClicked(QUrl("snapping.md"));
        QCOMPARE(reader->page().topic(), QStringLiteral("snapping"));
        QCOMPARE(reader->windowTitle(), app::manualPage("snapping")->title);
        reader->close();
        t.window->findChild<QAction*>("manual")->trigger(); // goes on where it ended
        QCOMPARE(reader->page().topic(), QStringLiteral("snapping"));
        t.window->findChild<QAction*>("about-algorithm")->trigger();
        QVERIFY(reader->page().algorithm());
        QVERIFY(reader->findChild<QListView*>()->isVisible());
        t.window->findChild<QAction*>("manual")->trigger();
        QCOMPARE(reader->page().topic(), QStringLiteral("snapping"));
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

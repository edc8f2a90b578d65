// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/keys_in_use.h"
#include "app/commands/set_style.h"
#include "app/lessons/lesson.h"
#include "app/scene/bounds.h"
#include "ui/bars/option_bar.h"
#include "ui/docks/algorithm_panel.h"
#include "ui/docks/line_panel.h"
#include "ui/look/key_tip.h"
#include "ui/menus/actions.h"
#include "ui/widgets/message_strip.h"
#include "ui/widgets/segments.h"
#include "ui/window/workspace_tabs.h"
#include "ui/window/workspaces.h"

#include <QAccessible>
#include <QApplication>
#include <QClipboard>
#include <QDockWidget>
#include <QDropEvent>
#include <QLineEdit>
#include <QMenu>
#include <QMenuBar>
#include <QMimeData>
#include <QScopeGuard>
#include <QSignalSpy>
#include <QStatusBar>

#include "tests/app/document/one_window.h"
#include "tests/app/document/sheet.h"
#include "tests/app/document/sheet_edits.h"
#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace window_main_window_test {

using namespace ui;

namespace {

const clipping::Window middle{{25, 25}, {75, 75}};

/// Panels behind another tab are kept off the screen.
bool inFront(const QDockWidget* dock) { return dock->isVisible() && dock->x() >= 0; }

void setWindow(TestWindow& t, const clipping::Window& window)
{
    app::Session& session = t.window->session();
    session.history.push(windowStep(session.document, window));
}

/// Which windows were hidden by the destructor of a class that they are derived from.
struct HiddenLate : QObject {
    HiddenLate() { qApp->installEventFilter(this); }
    bool eventFilter(QObject* watched, QEvent* event) override
    {
        if (!watched->isWidgetType())
            return false;
        const QByteArray name = watched->metaObject()->className();
        if (event->type() == QEvent::Show && static_cast<QWidget*>(watched)->isWindow())
            shown[watched] = name;
        else if (event->type() == QEvent::Hide && shown.value(watched, name) != name)
            late << shown[watched];
        return false;
    }

    QMap<QObject*, QByteArray> shown;
    QByteArrayList late;
};

} // namespace

class MainWindowTest : public QObject {
    Q_OBJECT

private slots:
    void windowsAreHiddenBeforeTheyAreDestroyed()
    {
        HiddenLate windows;
        {
            TestWindow t;
            t.show();
            for (const char* dialog : {"grid-own", "shortcuts"})
                t.run(dialog);
        }
        QVERIFY(windows.shown.values().contains("ui::GridDialog"));
        QCOMPARE(windows.late, QByteArrayList());
    }
    void mnemonicsAreUniqueInEachMenu()
    {
        const auto mnemonics = [](const QList<QAction*>& actions) {
            QStringList letters;
            for (const QAction* action : actions)
                if (const auto at = action->text().indexOf(u'&'); at >= 0)
                    letters << action->text().mid(at + 1, 1).toLower();
            return letters;
        };
        TestWindow t;
        QList<QList<QAction*>> lists{t.window->menuBar()->actions()};
        for (const QAction* top : t.window->menuBar()->actions())
            lists << top->menu()->actions();
        qsizetype all = 0;
        for (const auto& list : lists) {
            QStringList letters = mnemonics(list);
            const auto count = letters.size();
            all += count;
            letters.removeDuplicates();
            QVERIFY2(letters.size() == count, qPrintable(letters.join(' ')));
        }
        QVERIFY(all > 30);
    }
    void shortcutsAreUniqueAndNoneIsMissing()
    {
        TestWindow t;
        QHash<QString, QString> seen;
        for (const QAction* action : t.window->findChildren<QAction*>())
            for (const QKeySequence& key : action->shortcuts()) {
                const QString text = key.toString();
                QVERIFY2(!seen.contains(text) || seen[text] == action->text(),
                         qPrintable(text + ": " + seen.value(text) + ", " + action->text()));
                seen[text] = action->text();
            }
        for (const char* key : {"Ctrl+N", "Ctrl+O", "Ctrl+S", "Ctrl+Shift+S", "Ctrl+E", "Ctrl+Z",
                                "Ctrl+Y", "Ctrl+Shift+Z", "Ctrl+=", "F11", "Ctrl+Shift+A"})
            QVERIFY2(seen.contains(key), key);
    }
    void opensAFile()
    {
        TestWindow t;
        t.show();
        t.answers->open = t.twoLines();
        QTest::keyClick(t.window.get(), Qt::Key_O, Qt::ControlModifier);
        QTRY_VERIFY(!t.window->files().busy());
        QCOMPARE(t.window->session().scene.lines().size(), std::size_t(2));
        QVERIFY(t.window->windowTitle().startsWith("two.svg"));
        QCOMPARE(t.window->files().recent().size(), std::size_t(1));
        QCOMPARE(t.window->files().recent().front().lines, std::size_t(2));
    }
    void theTenthRecentFileHasTheKeyZero()
    {
        TestWindow t;
        t.show();
        for (int i = 1; i <= 11; ++i)
            t.open(t.file(QStringLiteral("%1.svg").arg(i),
                          "<svg xmlns='http://www.w3.org/2000/svg'><path d='M0 0H9'/></svg>"));
        for (QMenu* menu : t.window->findChildren<QMenu*>())
            if (menu->title() == "Open &recent") {
                emit menu->aboutToShow();
                QStringList texts;
                for (const QAction* action : menu->actions())
                    texts << action->text();
                QCOMPARE(
                    texts.first(10),
                    QStringList({"&1  11.svg", "&2  10.svg", "&3  9.svg", "&4  8.svg", "&5  7.svg",
                                 "&6  6.svg", "&7  5.svg", "&8  4.svg", "&9  3.svg", "&0  2.svg"}));
                menu->actions()[9]->trigger();
                t.window->files().wait();
                QVERIFY(t.window->windowTitle().startsWith("2.svg"));
                return;
            }
        QFAIL("there is no such menu");
    }
    void aBadFileChangesNothing()
    {
        TestWindow t;
        t.open(t.twoLines());
        QFile bad(t.path("bad.svg"));
        QVERIFY(bad.open(QIODevice::WriteOnly));
        bad.write("<svg><g>");
        bad.close();
        t.show();
        t.open(bad.fileName());
        QVERIFY(t.window->message().contains("bad.svg"));
        QVERIFY(t.window->message().contains("Nothing was changed"));
        QCOMPARE(t.window->session().scene.lines().size(), std::size_t(2));
    }
    void digitsChooseTheAlgorithmOnTheCanvasOnly()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        const auto all = clipping::algorithms();
        QCOMPARE(t.window->session().display().variant.algorithm, &clipping::exactAlgorithm());
        QTest::keyClick(t.drawingArea(), Qt::Key_2);
        QCOMPARE(t.window->session().display().variant.algorithm, &all[1]);
        auto* field = t.window->findChild<QDoubleSpinBox*>();
        field->setFocus();
        QTest::keyClick(field, Qt::Key_1);
        QCOMPARE(t.window->session().display().variant.algorithm, &all[1]);
    }
    void digitsChooseNoAlgorithmInTheWorkspaceDraw()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        const auto* algorithm = t.window->session().display().variant.algorithm;
        t.run("workspace-draw");
        t.window->canvas().setTool("hand"); // no clip window is chosen, and nothing takes numbers
        QTest::keyClick(t.drawingArea(), Qt::Key_2);
        QCOMPARE(t.window->session().display().variant.algorithm, algorithm);
        QVERIFY(t.window->statusBar()->currentMessage().contains("only while a clip window is"));
        auto* tabs = t.window->findChild<WorkspaceTabs*>();
        QTest::mouseClick(tabs, Qt::LeftButton, {}, tabs->tabRect(3).center()); // Learn
        QTest::keyClick(t.drawingArea(), Qt::Key_2);
        QVERIFY(t.window->session().display().variant.algorithm != algorithm);
    }
    void lettersChooseTheTool()
    {
        TestWindow t;
        t.show();
        QTest::keyClick(t.drawingArea(), Qt::Key_L);
        QCOMPARE(t.window->canvas().tool(), std::string_view("line"));
        QTest::keyClick(t.drawingArea(), Qt::Key_W);
        QCOMPARE(t.window->canvas().tool(), std::string_view("window"));
        QVERIFY(t.action("tool-window")->isChecked());
    }
    void aDroppedFileIsOpened()
    {
        TestWindow t;
        t.show();
        QMimeData data;
        data.setUrls({QUrl::fromLocalFile(t.twoLines())});
        QDragEnterEvent enter(QPoint(300, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(t.window.get(), &enter);
        QVERIFY(enter.isAccepted());
        QDropEvent drop(QPointF(300, 300), Qt::CopyAction, &data, Qt::LeftButton, {});
        QApplication::sendEvent(t.window.get(), &drop);
        QTRY_COMPARE(t.window->session().scene.lines().size(), std::size_t(2));
    }
    void whatAnotherProgramDropsComesToTheDrawing()
    {
        TestWindow t;
        t.show();
        QMimeData words, lines, other;
        words.setText("Roof");
        lines.setData("image/svg+xml",
                      "<svg xmlns='http://www.w3.org/2000/svg' width='9mm' height='9mm' "
                      "viewBox='0 0 9 9'><path d='M0 0 9 9' stroke='black'/></svg>");
        other.setData("application/x-other", "GIF89a");
        const QWidget* surface = t.window->canvas().paneSurface(0);
        const QPointF at = surface->rect().center() + QPoint(60, 40);
        const auto drop = [&](const QMimeData& data) {
            const QPointF place = surface->mapTo(t.window.get(), at);
            QDragEnterEvent enter(place.toPoint(), Qt::CopyAction, &data, Qt::LeftButton, {});
            QApplication::sendEvent(t.window.get(), &enter);
            if (!enter.isAccepted())
                return false;
            QDropEvent dropped(place, Qt::CopyAction, &data, Qt::LeftButton, {});
            QApplication::sendEvent(t.window.get(), &dropped);
            return true;
        };
        const app::Session& session = t.window->session();
        const auto middle = [&] {
            const clipping::Window box = session.selectionBounds().value();
            const app::Point on = t.window->canvas().view().toScreen((box.min + box.max) * 0.5);
            return (QPointF(on.x, on.y) - at).manhattanLength();
        };
        QVERIFY(drop(words));
        QCOMPARE(session.now().objects().size(), std::size_t(1));
        QVERIFY(middle() < 1);
        QVERIFY(drop(lines));
        QCOMPARE(session.now().objects().size(), std::size_t(2));
        QVERIFY(middle() < 1);
        QVERIFY(!drop(other));
        QCOMPARE(session.history.count(), 2);
    }
    void itAsksAboutUnsavedChanges()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        QVERIFY(!t.window->isWindowModified());
        setWindow(t, middle);
        QVERIFY(t.window->isWindowModified());
        t.answers->answer = Questions::Answer::Cancel;
        QVERIFY(!t.window->close());
        QCOMPARE(t.answers->asked, 1);
        t.answers->answer = Questions::Answer::Save;
        QVERIFY(!t.window->close()); // not before it is saved
        QTRY_VERIFY(!t.window->isVisible());
        const auto again = app::readFile(t.path("two.svg"));
        QCOMPARE(app::sheetOf(again.value->document).window, middle);
    }
    void dontSaveLeavesTheFile()
    {
        TestWindow t;
        t.open(t.twoLines());
        setWindow(t, middle);
        t.answers->answer = Questions::Answer::DontSave;
        t.window->files().startNew();
        QVERIFY(sheetOf(t.window->session().document).shapes.empty());
        QVERIFY(app::sheetOf(app::readFile(t.path("two.svg")).value->document).window != middle);
    }
    void closeLeavesAnEmptyDrawingAndTheStartPanel()
    {
        TestWindow t;
        t.show();
        t.open(t.twoLines());
        t.action("close")->trigger();
        QVERIFY(t.window->isVisible());
        QVERIFY(sheetOf(t.window->session().document).shapes.empty());
        QCOMPARE(t.window->files().name(), "Untitled");
        QVERIFY(t.window->showsPanel("start"));
        t.open(t.twoLines());
        setWindow(t, middle);
        t.answers->answer = Questions::Answer::Cancel;
        t.action("close")->trigger();
        QCOMPARE(sheetOf(t.window->session().document).window, middle); // the person keeps it
    }
    void itAsksBeforeOverwritingAnotherProgramsChange()
    {
        TestWindow t;
        t.open(t.twoLines());
        setWindow(t, middle);
        QFile file(t.path("two.svg"));
        QVERIFY(file.open(QIODevice::Append));
        file.setFileTime(QDateTime::currentDateTime().addSecs(60), QFile::FileModificationTime);
        file.close();
        QVERIFY(!t.saved()); // the prepared answer is no
        QVERIFY(t.window->isWindowModified());
    }
    void aLossyImportIsSavedAsANewFile()
    {
        TestWindow t;
        QFile file(t.path("lossy.svg"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("<svg xmlns='http://www.w3.org/2000/svg' width='10mm' height='10mm'>"
                   "<image/><path d='M0 0L5 5' stroke='#000'/></svg>");
        file.close();
        t.show();
        t.open(file.fileName());
        QVERIFY2(t.window->message().contains("cannot be kept"), qPrintable(t.window->message()));
        t.answers->asNewFile = false;
        QVERIFY(!t.saved());
        t.answers->asNewFile = true;
        t.answers->save = t.path("new.svg");
        QVERIFY(t.saved());
        QVERIFY(QFile::exists(t.path("new.svg")));
        QVERIFY(t.saved()); // now it is ours
    }
    void aCutImportIsSavedAsANewFile()
    {
        TestWindow t;
        QFile file(t.path("clipped.svg"));
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.write("<svg xmlns='http://www.w3.org/2000/svg' width='10mm' height='10mm'><clipPath "
                   "id='c'><circle r='5'/></clipPath><path d='M0 0L9 9' stroke='#000' "
                   "clip-path='url(#c)'/></svg>");
        file.close();
        t.show();
        t.open(file.fileName());
        QVERIFY2(t.window->message().contains("clip paths"), qPrintable(t.window->message()));
        t.answers->asNewFile = false;
        QVERIFY(!t.saved());
    }
    void drawingsAreSavedOnlyAsSvg()
    {
        TestWindow t;
        t.show();
        t.open(t.twoLines());
        t.answers->save = t.path("picture.png");
        QVERIFY(!t.saved(&Files::saveAs));
        QVERIFY(!QFile::exists(t.path("picture.png")));
        QVERIFY2(t.window->message().contains("SVG"), qPrintable(t.window->message()));
        QVERIFY(t.window->session().path().endsWith("two.svg"));
    }
    void exportsTheCutDrawing()
    {
        TestWindow t;
        t.open(t.twoLines());
        setWindow(t, middle);
        t.show();
        QTest::keyClick(t.window.get(), Qt::Key_E, Qt::ControlModifier);
        auto* file = t.window->findChild<QLineEdit*>("export-file");
        QVERIFY(file && file->text().endsWith("two-cut.svg"));
        file->setText(t.path("out.svg"));
        QTest::keyClick(file, Qt::Key_Return);
        QTRY_VERIFY(!t.window->files().busy());
        QVERIFY2(t.window->message().contains("Exported out.svg"), qPrintable(t.window->message()));
        const auto cut = app::readFile(t.path("out.svg"));
        const app::EditedDocument document(cut.value->document);
        const app::Scene scene(document);
        QCOMPARE(scene.lines().size(), std::size_t(1));
        QCOMPARE(scene.lines()[0], (clipping::Segment{{25, 50}, {75, 50}}));
    }
    void croppingCanBeUndone()
    {
        TestWindow t;
        t.open(t.twoLines());
        setWindow(t, middle);
        t.show();
        t.run("crop");
        QCOMPARE(t.window->session().scene.lines().size(), std::size_t(1));
        QVERIFY(t.window->message().startsWith("Cropped"));
        t.action("undo")->trigger();
        QCOMPARE(t.window->session().scene.lines().size(), std::size_t(2));
        QCOMPARE(t.window->message(), QString());
    }
    void croppingLeavesALockedLayerAlone()
    {
        TestWindow t;
        t.open(t.twoLines());
        setWindow(t, middle);
        t.show();
        auto layers = sheetOf(t.window->session().document).layers;
        layers.front().locked = true;
        ::setLayers(t.window->session().document, layers);
        const int before = t.window->session().history.count();
        t.run("crop");
        QCOMPARE(t.window->session().scene.lines().size(), std::size_t(2));
        QCOMPARE(t.window->session().history.count(), before);
        QCOMPARE(t.window->message(), "Nothing was cropped. Unchanged on locked layers: 1.");
    }
    void forgottenStepsAreReportedOnce()
    {
        TestWindow t;
        QSettings().setValue("undoMegabytes", 2);
        t.window = windowWithMenus();
        app::Session& session = t.window->session();
        QCOMPARE(session.history.limit(), std::size_t(2'000'000));
        app::Sheet sheet;
        sheet.shapes.resize(40'000);
        session.load({app::documentOf(sheet), {}});
        const auto restyle = [&session] {
            const app::ObjectRanges all(
                app::ObjectRange{0, sheetOf(session.document).shapes.size()});
            session.history.push(new app::SetStyle(
                session.document, all, [](app::Style& style) { style.width += 1; }, "Width"));
        };
        restyle();
        QCoreApplication::processEvents();
        QVERIFY(t.window->message().isEmpty());
        restyle();
        QTRY_COMPARE(t.window->message(), "The oldest steps can no longer be undone: undo may use "
                                          "at most 2 MB of memory (File, Settings…). Save a copy "
                                          "if you may need this state again.");
        QCOMPARE(session.history.count(), 1);
        t.window->tell({});
        restyle();
        QCOMPARE(session.history.forgotten(), 2);
        QCoreApplication::processEvents();
        QVERIFY(t.window->message().isEmpty());
        session.load(
            {app::documentOf(sheetOf(session.document)), {}}); // another drawing: reported again
        restyle();
        restyle();
        QTRY_VERIFY(!t.window->message().isEmpty());
    }
    void theMemoryForUndoIsChosenInTheSettings()
    {
        TestWindow t;
        const auto chosen = [&t] {
            QStringList on;
            for (const QAction* action : t.window->findChildren<QAction*>())
                if (action->objectName().startsWith(u"undo-memory-") && action->isChecked())
                    on << action->text();
            return on;
        };
        QCOMPARE(chosen(), QStringList("1 GB"));
        t.run("undo-memory-250");
        QCOMPARE(chosen(), QStringList("250 MB"));
        QCOMPARE(t.window->session().history.limit(), std::size_t(250'000'000));
        t.window = windowWithMenus(); // remembered
        QCOMPARE(chosen(), QStringList("250 MB"));
        QSettings().setValue("undoMegabytes", 123);
        t.window = windowWithMenus(); // none of the choices
        QCOMPARE(chosen(), QStringList());
        QCOMPARE(t.window->session().history.limit(), std::size_t(123'000'000));
    }
    void aFullListOfClipWindowsIsReported()
    {
        TestWindow t;
        app::ClipWindows windows;
        windows.list.resize(app::ClipWindows::most, {.visible = false});
        t.window->session().document.apply({.windows = windows});
        t.show();
        t.action("window-on-page")->trigger();
        QVERIFY(t.window->message().startsWith("No clip window was drawn."));
        t.window->tell({});
        t.window->canvas().setTool("window");
        QTest::mousePress(t.drawingArea(), Qt::LeftButton, Qt::ControlModifier, {100, 100});
        QTest::mouseRelease(t.drawingArea(), Qt::LeftButton, Qt::ControlModifier, {200, 200});
        QVERIFY(t.window->message().startsWith("No clip window was drawn."));
        QCOMPARE(t.window->session().history.count(), 0);
    }
    void croppingWithoutEffectIsNoStep()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        t.run("crop");
        QCOMPARE(t.window->session().history.count(), 0);
        QCOMPARE(t.window->message(),
                 "Nothing was cropped: the clip window keeps all of the drawing.");
    }
    void selectionKeysReportAnEmptySelection()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        const QString said = "Nothing is selected. Select an object first.";
        const QList<std::pair<const char*, QKeySequence>> commands{
            {"cut", QKeySequence::Cut},
            {"copy", QKeySequence::Copy},
            {"duplicate", QKeySequence("Ctrl+D")},
            {"delete", QKeySequence("Delete")}};
        for (const auto& [name, keys] : commands) {
            QVERIFY(!t.action(name)->isEnabled());
            QTest::keySequence(t.drawingArea(), keys);
            QVERIFY2(t.window->statusBar()->currentMessage() == said, name);
            t.window->statusBar()->clearMessage();
        }
        t.action("select-all")->trigger();
        for (const char* name : {"copy", "cut"}) {
            QVERIFY2(t.action(name)->isEnabled() && t.action(name)->statusTip().isEmpty(), name);
            QTest::keySequence(t.drawingArea(), t.action(name)->shortcut());
            QCOMPARE(t.window->statusBar()->currentMessage(), QString());
        }
    }
    void fitClipWindowNeedsAClipWindow()
    {
        TestWindow t;
        t.show();
        QVERIFY(!t.action("fit-window")->isEnabled());
        QTest::keyClick(t.drawingArea(), Qt::Key_3, Qt::ShiftModifier);
        QCOMPARE(t.window->statusBar()->currentMessage(),
                 "There is no clip window. Draw one first (W).");
        setWindow(t, middle);
        QVERIFY(t.action("fit-window")->isEnabled());
    }
    void theClipboardWarningDisappearsWithTheNextPaste()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        const QString warning =
            "The clipboard holds no drawing, no text and no image. Copy lines first.";
        const auto shapes = [&] { return sheetOf(t.window->session().document).shapes.size(); };
        for (const char* next : {"copy", "paste"}) {
            QGuiApplication::clipboard()->setText(" ");
            t.action("paste")->trigger();
            QCOMPARE(t.window->message(), warning);
            if (next == QByteArray("paste")) // from another window
                QGuiApplication::clipboard()->setText(
                    "<svg xmlns='http://www.w3.org/2000/svg' width='9' height='9'><path d='M0 "
                    "0H9' stroke='red'/></svg>");
            const std::size_t before = shapes();
            t.action("select-all")->trigger();
            t.action(next)->trigger();
            QCOMPARE(shapes() > before, next == QByteArray("paste"));
            QCOMPARE(t.window->message(), QString());
        }
        t.action("select-all")->trigger();
        t.window->tell({Message::Kind::Warning, "Another warning."});
        t.action("copy")->trigger();
        t.action("paste")->trigger();
        QCOMPARE(t.window->message(), "Another warning.");
    }
    void aTextIsPastedWhereThePointerIs()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        app::Session& session = t.window->session();
        QGuiApplication::clipboard()->setText("Wall");
        const QPoint pointer(200, 150);
        QCursor::setPos(t.drawingArea()->mapToGlobal(pointer));
        t.action("paste")->trigger();
        QCOMPARE(session.now().objects().size(), std::size_t(2));
        QCOMPARE(session.selection(), app::ObjectRanges({1}));
        const app::ObjectView text = session.now().objects()[1];
        const auto* recipe = std::get_if<app::TextRecipe>(&text.particulars().recipe);
        QVERIFY(recipe);
        QCOMPARE(recipe->text, "Wall");
        const auto box = app::boundsOf(session.scene.lines(), session.selection());
        QVERIFY(box);
        const auto at = t.window->canvas().view().toScreen((box->min + box->max) * 0.5);
        QVERIFY2(std::abs(at.x - pointer.x()) < 2 && std::abs(at.y - pointer.y()) < 2,
                 qPrintable(QString("%1 %2").arg(at.x).arg(at.y)));
        t.action("undo")->trigger();
        QCOMPARE(session.now().objects().size(), std::size_t(1));
    }
    void aPictureIsPastedBelowTheDrawing()
    {
        TestWindow t;
        t.open(t.twoLines());
        QImage picture(4, 4, QImage::Format_RGB32);
        picture.fill(Qt::red);
        QGuiApplication::clipboard()->setImage(picture);
        t.action("paste")->trigger();
        app::Session& session = t.window->session();
        QTRY_COMPARE(session.history.count(), 1);
        QCOMPARE(session.history.text(0), "Place image");
        const app::Containers& tree = session.now().containers();
        QCOMPARE(tree.underlaid(), std::vector{tree.childrenOf(0).front()});
        t.action("undo")->trigger();
        QVERIFY(!session.now().containers().isUnderlaid());
    }
    void clipboardAndSelection()
    {
        TestWindow t;
        t.open(t.twoLines());
        app::Session& session = t.window->session();
        t.action("select-all")->trigger();
        QCOMPARE(session.selection().size(), std::size_t(1));
        t.action("copy")->trigger();
        t.action("paste")->trigger();
        QCOMPARE(sheetOf(session.document).shapes.size(), std::size_t(2));
        QCOMPARE(session.selection(), (app::ObjectRanges{1}));
        t.action("duplicate")->trigger();
        QCOMPARE(sheetOf(session.document).shapes.size(), std::size_t(3));
        t.action("delete")->trigger();
        QCOMPARE(sheetOf(session.document).shapes.size(), std::size_t(2));
        t.action("undo")->trigger();
        t.action("undo")->trigger();
        t.action("undo")->trigger();
        QCOMPARE(sheetOf(session.document).shapes.size(), std::size_t(1));
    }
    void themesSwitch()
    {
        TestWindow t;
        t.window->setTheme(Theme::Dark);
        QVERIFY(lookOf(t.window->palette()).dark);
        QVERIFY(lookOf(t.window->canvas().palette()).dark);
        t.window->setTheme(Theme::Light);
        QVERIFY(!lookOf(t.window->palette()).dark);
        QCOMPARE(QSettings().value("theme").toInt(), int(Theme::Light));
    }
    // After what it backs out of before: tool and selection.
    void escapeLeavesThePresentation()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        t.run("presentation");
        QVERIFY(t.window->isPresenting());
        t.window->canvas().setTool("line");
        t.window->session().select({0});
        t.window->canvas().setFocus();
        for (int i = 0; i < 2; ++i) {
            QTest::keyClick(t.drawingArea(), Qt::Key_Escape);
            QVERIFY(t.window->isPresenting());
        }
        QCOMPARE(t.window->canvas().tool(), std::string_view("select"));
        QVERIFY(t.window->session().selection().empty());
        QTest::keyClick(t.drawingArea(), Qt::Key_Escape);
        QVERIFY(!t.window->isPresenting());
        QTest::keyClick(t.drawingArea(), Qt::Key_Escape); // has nothing to leave
        QVERIFY(!t.window->isPresenting());
    }
    void iconsOfTheOptionBarFollowTheTheme()
    {
        TestWindow t;
        t.show();
        const auto pictureIn = [](const MainWindow& window) {
            return window.findChild<OptionBar*>()->grab().toImage();
        };
        const QImage light = pictureIn(*t.window);
        t.window->setTheme(Theme::Dark);
        QCoreApplication::processEvents();
        const QImage switched = pictureIn(*t.window);
        QVERIFY(switched != light);
        TestWindow fresh;
        fresh.show();
        fresh.window->setTheme(Theme::Dark);
        fresh.window = windowWithMenus(); // that never was in the light theme
        fresh.window->resize(t.window->size());
        fresh.show();
        QCOMPARE(switched, pictureIn(*fresh.window));
    }
    void tooltipsOfTheOptionBarShowTheShortcuts()
    {
        TestWindow t;
        QCOMPARE(t.action("undo")->toolTip(), "Undo (Ctrl+Z)");
        QCOMPARE(t.action("export")->toolTip(), "Export (Ctrl+E)");
        app::Session& session = t.window->session();
        session.history.push(addLayer(session.document, "Ink"));
        QCOMPARE(t.action("undo")->toolTip(), "Undo Add layer (Ctrl+Z)");
    }
    void startShowsASampleAndThenTheAlgorithmPanel()
    {
        TestWindow t;
        t.window->showStart();
        t.show();
        auto* start = t.window->findChild<QDockWidget*>("start");
        auto* algorithm = t.window->findChild<QDockWidget*>("algorithm");
        QTRY_VERIFY(inFront(start));
        QVERIFY(!inFront(algorithm));
        QVERIFY(t.window->session().scene.lines().size() > 10000);
        QCOMPARE(t.window->canvas().tool(), std::string_view("window"));
        setWindow(t, {{50, 50}, {100, 100}});
        QTRY_VERIFY(inFront(algorithm));
        QVERIFY(QSettings().value("windowDragged").toBool());
        QTRY_VERIFY(!t.window->findChild<WindowNote*>());
    }
    void theFirstStartNoteSaysHowToGetAClipWindow()
    {
        TestWindow t;
        t.window->showStart();
        t.show();
        const auto* note = t.window->findChild<WindowNote*>();
        QVERIFY(note->text().contains("Drag the clip window"));
        t.action("new")->trigger();
        QVERIFY(note->text().startsWith("<b>Draw a clip window (W),</b>"));
        QVERIFY(note->text().contains("Lay window on page"));
        app::Session& session = t.window->session();
        session.setPreview({.windows = withWindow(session.now().windows(), middle)});
        QVERIFY(note->text().contains("Drag the clip window"));
        session.setPreview({});
        QVERIFY(note->text().startsWith("<b>Draw a clip window (W),</b>"));
        const auto usual = qScopeGuard([] { KeyNews::get().tell(app::standardKeysInSentences()); });
        KeyNews::get().tell({{"tool-window", "F10"}});
        QVERIFY(note->text().startsWith("<b>Draw a clip window (F10),</b>"));
    }
    void commandsAreRefreshedOnceForAStep()
    {
        const TestWindow t;
        const QSignalSpy refreshed(t.window.get(), &MainWindow::actionsOutdated);
        emit t.window->session().history.indexChanged(0);
        QCOMPARE(refreshed.count(), 1);
    }
    void theFirstStartNoteIsNotShownInTheWorkspaceDraw()
    {
        TestWindow t;
        t.window->showStart();
        t.show();
        const auto* note = t.window->findChild<WindowNote*>();
        QVERIFY(note->isVisible());
        t.run("workspace-draw");
        QTRY_VERIFY(!note->isVisible());
        t.run("workspace-cut");
        QTRY_VERIFY(note->isVisible());
    }
    void theFirstStartNoteHidesNothing()
    {
        TestWindow t;
        t.window->showStart();
        t.show();
        const auto placeOf = [&](const QWidget& widget) {
            return QRect(widget.mapTo(t.window.get(), QPoint()), widget.size());
        };
        const auto* note = t.window->findChild<WindowNote*>();
        for (const QSize size : {QSize(1280, 800), QSize(1024, 640), QSize(1900, 1000)}) {
            t.window->resize(size);
            QTRY_COMPARE(t.window->size(), size);
            QCoreApplication::processEvents();
            QVERIFY(note->isVisible());
            const QRect canvas = placeOf(t.window->canvas());
            const auto drawn = *app::boundsOf(t.window->session().scene.lines());
            const app::Point highest = t.window->canvas().view().toScreen(drawn.min);
            const int top = canvas.top() + t.window->canvas().drawingCorner().y() + int(highest.y);
            QVERIFY(placeOf(*note).bottom() < top);
            QVERIFY(note->height() >= note->heightForWidth(note->width()));
            QVERIFY(canvas.height() > size.height() / 2);
        }
        t.window->session().microscope.open(app::lessons()[0].pages[0].tracedLine);
        QVERIFY(!note->isVisible());
        t.window->session().microscope.close();
        QVERIFY(note->isVisible());
    }
    void itAsksAboutASampleOnlyIfItWasChanged()
    {
        TestWindow t;
        t.window->showStart();
        t.show();
        setWindow(t, {{50, 50}, {100, 100}});
        t.window->files().openSample(app::samples()[1]);
        QCOMPARE(t.answers->asked, 0);
        QCOMPARE(t.window->files().name(), app::samples()[1].title);
        t.action("select-all")->trigger();
        t.action("delete")->trigger();
        t.window->files().startNew();
        QCOMPARE(t.answers->asked, 1);
    }
    void aMessageLeavesTheViewAsItIs()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        const auto before = t.window->canvas().view();
        t.window->tell({Message::Kind::Warning, "Nothing is selected."});
        QCoreApplication::processEvents();
        const auto* strip = t.window->findChild<MessageStrip*>();
        QVERIFY(strip->isVisible() && strip->height() > 20);
        const Canvas& canvas = t.window->canvas();
        QCOMPARE(strip->mapToGlobal(QPoint()), canvas.mapToGlobal(canvas.drawingCorner()));
        QCOMPARE(t.window->canvas().view().zoom, before.zoom);
        QVERIFY(t.window->canvas().view().toScreen({0, 0}) == before.toScreen({0, 0}));
        t.window->tell({});
        QCoreApplication::processEvents();
        QVERIFY(!strip->isVisible());
        QVERIFY(t.window->canvas().view().toScreen({0, 0}) == before.toScreen({0, 0}));
    }
    void startIsShownAgain()
    {
        TestWindow t;
        t.window->showStart();
        t.show();
        t.window->files().startNew();
        auto* start = t.window->findChild<QDockWidget*>("start");
        QTRY_VERIFY(!inFront(start));
        t.action("start")->trigger();
        QTRY_VERIFY(inFront(start));
        QVERIFY(start->width() < 600 && start->x() > 600);
    }
    void stackedPanelsHaveTitles()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        t.window->resize(1440, 1400); // room below a list of any number of algorithms
        t.window->choose(findWorkspace("workspace-learn"));
        for (const char* key : {"algorithm", "line"}) {
            auto* dock = t.window->findChild<QDockWidget*>(key);
            QTRY_VERIFY2(dock->titleBarWidget()->height() > 20, key);
        }
        for (int height = 1400; height >= 640; height -= 20) // as it is dragged: at last, tabs
            t.window->resize(1280, height);
        QTRY_COMPARE(t.window->height(), 640);
        auto* line = t.window->findChild<QDockWidget*>("line");
        QTRY_VERIFY(line->titleBarWidget()->height() == 0 || !line->titleBarWidget()->isVisible());
        QTRY_VERIFY(inFront(t.window->findChild<QDockWidget*>("algorithm")));
    }
    void noPanelIsSmallerThanItsContent()
    {
        for (const int height : {760, 800, 900, 1200}) {
            TestWindow t;
            t.open(t.twoLines());
            t.window->choose(findWorkspace("workspace-learn"));
            t.window->resize(1280, height);
            t.show();
            QTest::keyClick(t.window.get(), Qt::Key_F8);
            auto* line = t.window->findChild<QDockWidget*>("line");
            QTRY_VERIFY(t.window->findChild<LinePanel*>()->steps().contains("Visible"));
            QTRY_VERIFY(inFront(line));
            QCOMPARE(t.window->height(), height);
            for (const char* key : {"algorithm", "window", "line", "layers"}) {
                const auto* dock = t.window->findChild<QDockWidget*>(key);
                const QWidget* body = dock->widget();
                const auto whole = [&] {
                    const int below = dock->y() + dock->height();
                    return body->height() + 1 >= body->minimumSizeHint().height() // Qt keeps one
                           && below <= t.window->centralWidget()->geometry().bottom() + 1
                           && std::ranges::none_of(
                               t.window->findChildren<QDockWidget*>(), [&](auto* other) {
                                   return other != dock && inFront(other)
                                          && other->geometry().intersects(dock->geometry());
                               });
                };
                if (inFront(dock))
                    QTRY_VERIFY2(whole(), qPrintable(QString("%1 at %2").arg(key).arg(height)));
            }
        }
    }
    void layoutIsKeptAndReset()
    {
        TestWindow t;
        t.show();
        auto* layers = t.window->findChild<QDockWidget*>("layers");
        QTRY_VERIFY(layers->isVisible());
        t.window->addDockWidget(Qt::LeftDockWidgetArea, layers);
        QVERIFY(t.window->close());
        const auto again = windowWithMenus();
        auto* kept = again->findChild<QDockWidget*>("layers");
        QCOMPARE(again->dockWidgetArea(kept), Qt::LeftDockWidgetArea);
        again->resetLayout();
        QCOMPARE(again->dockWidgetArea(kept), Qt::RightDockWidgetArea);
    }
    void panesAreChosenAndRemembered()
    {
        TestWindow t;
        t.open(t.twoLines());
        t.show();
        auto* segments = t.window->findChild<OptionBar*>()->findChild<Segments*>("panes");
        QCOMPARE(segments->chosen(), 0);
        t.action("panes-4")->trigger();
        QCOMPARE(t.window->canvas().panes().size(), std::size_t(4));
        QCOMPARE(segments->chosen(), 2);
        t.action("next-pane")->trigger();
        t.action("next-pane")->trigger();
        QCOMPARE(t.window->canvas().panes().active(), std::size_t(2));
        QTest::keyClick(t.drawingArea(), Qt::Key_6); // KWC, in the active pane
        QTest::keyClick(t.drawingArea(), Qt::Key_V);
        const auto& chosen = t.window->canvas().panes().chosen();
        QCOMPARE(chosen.algorithm, clipping::findAlgorithm("kwc"));
        t.action("close-pane")->trigger();
        QCOMPARE(segments->chosen(), -1); // three is none of the choices
        QVERIFY(t.window->canvas().focusProxy()->hasFocus());
        for (QAbstractButton* button : segments->findChildren<QAbstractButton*>())
            if (button->text() == "2")
                button->click();
        QCOMPARE(t.window->canvas().panes().size(), std::size_t(2));
        const auto before = t.window->canvas().panes();
        const auto again = windowWithMenus();
        QVERIFY(std::ranges::equal(again->canvas().panes().choices(), before.choices()));
        QCOMPARE(again->session().display().variant.algorithm, before.chosen().algorithm);
        t.action("panes-all")->trigger();
        QCOMPARE(segments->chosen(), 3);
        t.action("panes-1")->trigger();
        QVERIFY(!t.action("close-pane")->isEnabled());
    }
    void fitsTheSmallestScreen()
    {
        TestWindow t;
        t.window->resize(1024, 640);
        t.show();
        QCOMPARE(t.window->size(), QSize(1024, 640));
    }
    void everyButtonAndFieldHasAName()
    {
        TestWindow t;
        t.window->showStart();
        t.show();
        t.action("panes-4")->trigger();
        int controls = 0;
        for (const QWidget* widget : t.window->findChildren<QWidget*>()) {
            const bool control =
                widget->focusPolicy() != Qt::NoFocus
                && (widget->inherits("QAbstractButton") || widget->inherits("QComboBox")
                    || widget->inherits("QAbstractSpinBox")
                    || widget->inherits("QAbstractItemView"));
            if (!control || !widget->isVisible())
                continue;
            ++controls;
            QAccessibleInterface* read =
                QAccessible::queryAccessibleInterface(const_cast<QWidget*>(widget));
            QVERIFY2(read && !read->text(QAccessible::Name).isEmpty(),
                     qPrintable(QString(widget->metaObject()->className()) + " "
                                + widget->objectName() + " in "
                                + widget->parent()->metaObject()->className()));
        }
        QVERIFY(controls > 10);
    }
};

} // namespace window_main_window_test

TEST_CLASS(window_main_window_test::MainWindowTest, Widgets)
#include "tests/ui/window/main_window_test.moc"

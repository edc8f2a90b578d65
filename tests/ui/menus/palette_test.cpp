// SPDX-License-Identifier: GPL-3.0-or-later
// Ctrl+K.
#include "app/document/document_builder.h"
#include "ui/explanation/explanation_window.h"
#include "ui/explanation/page_view.h"
#include "ui/menus/palette.h"
#include "ui/window/keyboard.h"

#include <QLineEdit>
#include <QListView>
#include <QMenuBar>
#include <QSignalSpy>
#include <QStatusBar>

#include "tests/test_class.h"
#include "tests/ui/tools/hand.h"

namespace menus_palette_test {

using namespace ui;

namespace {

struct Finder : TestWindow {
    Finder()
    {
        window->show();
        QVERIFY(QTest::qWaitForWindowActive(window.get()));
        open();
    }
    // By its key once only: to the offscreen platform a closed popup is still the active window.
    void open()
    {
        window->canvas().setFocus();
        if (palette())
            action("find-command")->trigger();
        else
            QTest::keyClick(window->canvas().focusProxy(), Qt::Key_K, Qt::ControlModifier);
        QVERIFY(palette() && palette()->isVisible());
    }
    Palette* palette() const { return window->findChild<Palette*>(); }
    QLineEdit& typed() const { return *palette()->findChild<QLineEdit*>("palette-typed"); }
    QListView& list() const { return *palette()->findChild<QListView*>("palette-rows"); }
    void type(const QString& text) const
    {
        typed().selectAll();
        typed().insert(text); // keyClicks() types no "…"
    }
    void press(Qt::Key key) const
    {
        QTest::keyClick(&typed(), key);
        QCoreApplication::processEvents(); // what is run then
    }
    QStringList lines() const
    {
        QStringList all;
        for (int row = 0; row < list().model()->rowCount(); ++row)
            all << list().model()->index(row, 0).data().toString();
        return all;
    }
    QString chosen() const { return list().currentIndex().data().toString(); }
};

} // namespace

class PaletteTest : public QObject {
    Q_OBJECT

private slots:
    void everyCommandOfTheMenusIsFoundFirst()
    {
        Finder finder;
        int looked = 0;
        for (const QAction* action : commands(*finder.window)) {
            QString name = action->text();
            name.remove(u'&');
            if (name.isEmpty() || action->objectName() == "own-name")
                continue;
            finder.type(name);
            QVERIFY2(finder.lines().contains(name), qPrintable(name));
            if (action->isEnabled()) // else those that are possible come before
                QVERIFY2(finder.lines().value(1) == name, qPrintable(name));
            ++looked;
        }
        QVERIFY(looked > 120);
    }
    void enterRunsWhatIsChosen()
    {
        Finder finder;
        finder.type("presentation");
        QCOMPARE(finder.chosen(), QStringLiteral("Presentation"));
        finder.type("star");
        finder.press(Qt::Key_Down);
        finder.press(Qt::Key_Up);
        QCOMPARE(finder.chosen(), QStringLiteral("Star"));
        finder.press(Qt::Key_Return);
        QVERIFY(!finder.palette()->isVisible());
        QCOMPARE(finder.window->canvas().tool(), std::string_view("star"));
        QVERIFY(finder.window->canvas().focusProxy()->hasFocus());
    }
    void whatWasRunComesFirst()
    {
        Finder finder;
        finder.type("ellipse");
        finder.press(Qt::Key_Return);
        finder.open();
        QCOMPARE(finder.lines(), (QStringList{"Recent", "Ellipse"}));
        finder.press(Qt::Key_Escape);
        QVERIFY(!finder.palette()->isVisible());
        finder.open();
        finder.type("select");
        finder.press(Qt::Key_Return);
        finder.open();
        QCOMPARE(finder.lines(), (QStringList{"Recent", "Select", "Ellipse"}));
        const QString ellipse = QSettings().value("palette/recent").toStringList().last();
        QSettings().setValue("palette/recent", QStringList{"gone", "undo", ellipse});
        finder.type("e"); // of those that begin with it, what was run
        QCOMPARE(finder.chosen(), QStringLiteral("Ellipse"));
        QSettings().setValue("palette/recent", QStringList{"start"});
        finder.type("star"); // the best comes first, whatever was run
        QCOMPARE(finder.chosen(), QStringLiteral("Star"));
        QSettings().setValue("palette/recent", QStringList{"undo", ellipse});
        finder.type("");
        QCOMPARE(finder.lines(), (QStringList{"Recent", "Ellipse", "Undo"}));
        QCOMPARE(finder.chosen(), QStringLiteral("Ellipse")); // nothing can be undone
    }
    void whatCannotBeRunSaysWhy()
    {
        Finder finder;
        finder.type("undo"); // not the memory for it
        QCOMPARE(finder.chosen(), QStringLiteral("Undo"));
        finder.type("rotate 90");
        const QModelIndex row = finder.list().currentIndex();
        QVERIFY(row.isValid());
        finder.press(Qt::Key_Return); // nothing is selected
        QVERIFY(finder.palette()->isVisible());
        QVERIFY(!finder.window->statusBar()->currentMessage().isEmpty());
    }
    void windowsAndLayersOfTheDrawingAreChosen()
    {
        Finder finder;
        finder.palette()->close();
        app::Session& session = finder.window->session();
        app::DocumentBuilder builder;
        builder.open({.name = QStringLiteral("Quay walls")});
        builder.add({.path = app::Path(clipping::Segment{{0, 0}, {9, 9}}),
                     .style = {.stroke = app::Colour{}}});
        builder.close();
        const app::RectangleShape box{{{1000, 1000}, {1200, 1200}}};
        session.load({builder.take(app::Page{}, {},
                                   {{{.name = QStringLiteral("First"), .shape = box},
                                     {.name = QStringLiteral("Quay window"), .shape = box}}}),
                      {}});
        finder.open();
        finder.type("quay");
        QCOMPARE(finder.lines(), (QStringList{"Commands", "Quay walls", // to move to
                                              "In this drawing", "Quay window", "Quay walls"}));
        QCOMPARE(finder.chosen(), QStringLiteral("Quay window"));
        finder.press(Qt::Key_Return);
        QCOMPARE(session.windowNumber(), std::size_t(1));
        const app::View& view = finder.window->canvas().view(); // it was brought into view
        const app::Point at = view.toScreen({1100, 1100});
        QVERIFY(at.x > 0 && at.y > 0 && at.x < view.size.x && at.y < view.size.y);
        finder.open();
        finder.type("quay walls"); // nothing is selected that could be moved to it
        finder.press(Qt::Key_Return);
        QCOMPARE(session.selection().size(), std::size_t(1));
        finder.open();
        finder.type("30 mm"); // for the window's width
        QCOMPARE(finder.chosen(), QStringLiteral("Set width of Quay window"));
        finder.press(Qt::Key_Return);
        QCOMPARE(session.history.undoText(), QStringLiteral("Resize clip window"));
    }
    void whatIsHiddenSaysSo()
    {
        Finder finder;
        app::Session& session = finder.window->session();
        app::ClipWindows windows{{{.name = QStringLiteral("Quay"),
                                   .shape = app::RectangleShape{{{0, 0}, {9, 9}}},
                                   .visible = false}}};
        session.document.apply({.windows = windows}); // the open list follows
        finder.type("quay");
        finder.press(Qt::Key_Return);
        QVERIFY(finder.window->message().contains("Quay is hidden"));
    }
    void anotherDrawingClosesIt()
    {
        Finder finder;
        finder.window->session().load({}, {});
        QVERIFY(!finder.palette()->isVisible());
    }
    void pagesOfTheManualAreOpened()
    {
        Finder finder;
        finder.press(Qt::Key_Tab);
        finder.press(Qt::Key_Tab);
        finder.press(Qt::Key_Tab); // help only
        finder.type("shapes of clip windows");
        QCOMPARE(finder.chosen(), QStringLiteral("Shapes of clip windows"));
        finder.press(Qt::Key_Return);
        auto* reader = finder.window->findChild<ExplanationWindow*>();
        QVERIFY(reader && reader->isVisible());
        QCOMPARE(reader->page().topic(), QStringLiteral("window-shapes"));
    }
    void samplesAreFound()
    {
        Finder finder;
        finder.type("landscape");
        QCOMPARE(finder.chosen(), QStringLiteral("Hatched landscape"));
        finder.press(Qt::Key_Return);
        finder.window->files().wait();
        QCOMPARE(finder.window->files().sample(), QStringLiteral("landscape"));
    }
    void tabShowsOneKindOnly()
    {
        Finder finder;
        finder.type("window");
        QVERIFY(finder.lines().contains("Commands") && finder.lines().contains("Help"));
        finder.press(Qt::Key_Tab);
        QVERIFY(finder.lines().contains("Commands") && !finder.lines().contains("Help"));
        finder.press(Qt::Key_Backtab);
        QVERIFY(finder.lines().contains("Commands") && finder.lines().contains("Help"));
        finder.press(Qt::Key_Backtab);
        QVERIFY(!finder.lines().contains("Commands") && finder.lines().contains("Help"));
        finder.press(Qt::Key_Tab);
        QVERIFY(finder.lines().contains("Commands") && finder.lines().contains("Help"));
    }
    void whatDoesNotExistIsSaid()
    {
        Finder finder;
        finder.type("xyzzy quux");
        QCOMPARE(finder.lines(), QStringList("Nothing is called “xyzzy quux”."));
        finder.press(Qt::Key_Down);
        finder.press(Qt::Key_Return);
        QVERIFY(finder.palette()->isVisible());
        finder.type(QString(10'000, u'x'));
        QCOMPARE(finder.lines().size(), 1);
    }
    void aPanelIsBroughtToTheFront()
    {
        Finder finder;
        finder.type("layers");
        QCOMPARE(finder.chosen(), QStringLiteral("Layers"));
        finder.press(Qt::Key_Return);
        QVERIFY(finder.window->showsPanel("layers"));
        finder.open();
        finder.press(Qt::Key_Return); // once more
        QVERIFY(finder.window->showsPanel("layers"));
    }
    void aSmallWindowHasAll()
    {
        Finder finder;
        QCOMPARE(finder.palette()->width(), 640);
        finder.palette()->close();
        finder.window->resize(600, 400);
        finder.open();
        finder.type("e");
        const QRect window(finder.window->mapToGlobal(QPoint()), finder.window->size());
        QVERIFY(window.contains(
            QRect(finder.palette()->mapToGlobal(QPoint()), finder.palette()->size())));
    }
    void aClickRuns()
    {
        Finder finder;
        finder.type("polygon");
        const QRect row = finder.list().visualRect(finder.list().currentIndex());
        QTest::mouseClick(finder.list().viewport(), Qt::LeftButton, {}, row.center());
        QCoreApplication::processEvents();
        QCOMPARE(finder.window->canvas().tool(), std::string_view("polygon"));
    }
};

} // namespace menus_palette_test

TEST_CLASS(menus_palette_test::PaletteTest, Widgets)
#include "tests/ui/menus/palette_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lettering/lettering.h"

#include <QInputMethodEvent>
#include <QPlainTextEdit>
#include <QSignalSpy>

#include "tests/ui/tools/hand.h"

// Texts are typed on the canvas, edited and converted, with mouse and keys.
class TextTest : public QObject {
    Q_OBJECT

    struct Writer : Hand {
        Writer() : Hand({}) { canvas.setTool("text"); }
        std::size_t count() { return session.now().objects().size(); }
        const app::TextRecipe* text(std::size_t object = 0)
        {
            return std::get_if<app::TextRecipe>(
                &session.now().objects()[object].particulars().recipe);
        }
        QPlainTextEdit& field() { return *canvas.findChild<QPlainTextEdit*>(); }
        QString written(std::size_t object = 0)
        {
            return text(object) ? text(object)->text : QStringLiteral("(no text)");
        }
        bool isDrawn(std::size_t object = 0)
        {
            return text(object)
                   && app::makes(*text(object), session.now().objects()[object].path().subpaths());
        }
    };

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void clickTypeEnter()
    {
        Writer hand;
        const auto variant = hand.session.variant();
        hand.click({20, 50});
        QVERIFY(hand.field().hasFocus());
        hand.type("Wall 1 vgz");
        QCOMPARE(hand.count(), std::size_t(0));
        Hand::key(Qt::Key_Return);
        QCOMPARE(hand.count(), std::size_t(1));
        QCOMPARE(hand.written(), "Wall 1 vgz");
        QVERIFY(hand.isDrawn() && hand.isNear(hand.text()->at, {20, 50}));
        QCOMPARE(hand.text()->size, 5.0);
        QCOMPARE(hand.session.history.undoText(), "Write text");
        QVERIFY(!hand.field().isVisible() && hand.surface().hasFocus());
        QVERIFY(hand.canvas.tool() == "text" && hand.session.variant() == variant);
        hand.session.history.undo();
        QCOMPARE(hand.count(), std::size_t(0));
    }
    void aTypedPlaceIsExact()
    {
        Writer hand;
        hand.move({10, 10}, {});
        hand.type("30,40\n");
        hand.type("A\n");
        QVERIFY(hand.text() && hand.text()->at == app::Point(30, 40));
    }
    void escKeepsWhatIsTypedAndEmptyTextMakesNothing()
    {
        Writer hand;
        hand.click({20, 50});
        hand.type("A");
        Hand::key(Qt::Key_Escape);
        QCOMPARE(hand.written(), "A");
        hand.click({80, 50});
        Hand::key(Qt::Key_Escape);
        hand.click({80, 50});
        hand.type("  ");
        Hand::key(Qt::Key_Return);
        QCOMPARE(hand.count(), std::size_t(1));
        QCOMPARE(hand.session.history.count(), 1);
    }
    void anotherToolAndAClickBesideKeepIt()
    {
        Writer hand;
        hand.click({20, 80});
        hand.type("A");
        hand.click({20, 30});
        hand.type("B");
        hand.canvas.setTool("line");
        QCOMPARE(hand.count(), std::size_t(2));
        QCOMPARE(hand.written(1), "B");
        QVERIFY(!hand.field().isVisible());
    }
    void linesBreakWithShift()
    {
        Writer hand;
        hand.click({20, 30});
        hand.type("A");
        Hand::key(Qt::Key_Return, Qt::ShiftModifier);
        hand.type("B");
        Hand::key(Qt::Key_Return);
        QCOMPARE(hand.written(), "A\nB");
    }
    void aDoubleClickEdits()
    {
        Writer hand;
        hand.click({20, 50});
        hand.type("LT");
        Hand::key(Qt::Key_Return);
        const auto first = *hand.text();
        hand.canvas.setTool("select");
        const app::Point onL = hand.path().start;
        hand.doubleClick(onL);
        QVERIFY(hand.canvas.tool() == "text" && hand.field().hasFocus());
        QCOMPARE(hand.field().toPlainText(), "LT");
        hand.type("LV");
        QCOMPARE(hand.session.history.count(), 1);
        Hand::key(Qt::Key_Return);
        QVERIFY(hand.canvas.tool() == "select");
        QCOMPARE(hand.count(), std::size_t(1));
        QCOMPARE(hand.session.history.count(), 2);
        QCOMPARE(hand.session.history.undoText(), "Edit text");
        QVERIFY(hand.isDrawn() && hand.written() == "LV" && hand.text()->at == first.at);
        hand.session.history.undo();
        QVERIFY(*hand.text() == first && hand.isDrawn());
        hand.doubleClick(onL);
        Hand::key(Qt::Key_Return); // nothing was changed
        QCOMPARE(hand.session.history.count(), 2);
        QCOMPARE(hand.session.history.index(), 1);
    }
    void anEmptiedTextIsRemoved()
    {
        Writer hand;
        hand.click({20, 50});
        hand.type("L\n");
        hand.click(hand.path().start);
        Hand::key(Qt::Key_Backspace);
        Hand::key(Qt::Key_Return);
        QCOMPARE(hand.count(), std::size_t(0));
        hand.session.history.undo();
        QCOMPARE(hand.written(), "L");
    }
    void fontAndSizeAreKeptForTheNextText()
    {
        Writer hand;
        hand.click({20, 50});
        hand.type("L");
        Hand::key(Qt::Key_Tab);
        Hand::key(Qt::Key_Down); // the next font
        Hand::key(Qt::Key_Tab);
        hand.type("12mm\n");
        QVERIFY(hand.field().hasFocus());
        hand.type("T\n");
        QCOMPARE(hand.written(), "LT");
        QCOMPARE(hand.text()->size, 12.0);
        QCOMPARE(hand.text()->font, "Hershey Sans medium");
        hand.click({100, 50});
        hand.type("M\n");
        QVERIFY(hand.text(1)->font == hand.text()->font && hand.text(1)->size == 12);
    }
    void anInputMethodWrites()
    {
        Writer hand;
        hand.click({20, 50});
        QInputMethodEvent event;
        event.setCommitString("Ώρα");
        QApplication::sendEvent(&hand.field(), &event);
        Hand::key(Qt::Key_Return);
        QCOMPARE(hand.written(), "Ώρα");
        QVERIFY(hand.isDrawn());
    }
    void missingLettersAreNamed()
    {
        Writer hand;
        QSignalSpy refused(&hand.session, &app::Session::refused);
        hand.click({20, 50});
        hand.field().insertPlainText("A漢");
        Hand::key(Qt::Key_Return);
        QCOMPARE(hand.written(), "A漢");
        QCOMPARE(refused.size(), 1);
        QVERIFY(refused[0][0].toString().contains("漢"));
    }
    void undoWhileTypingChangesTheFieldOnly()
    {
        Writer hand;
        hand.click({20, 80});
        hand.type("A\n");
        hand.click({20, 30});
        hand.type("B");
        Hand::key(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(hand.count(), std::size_t(1));
        QCOMPARE(hand.field().toPlainText(), "");
    }
    void aMovedTextStaysAText()
    {
        Writer hand;
        hand.click({20, 50});
        hand.type("L\n");
        hand.session.select({0});
        hand.canvas.setTool("select");
        Hand::key(Qt::Key_Right);
        QVERIFY(hand.isDrawn() && hand.isNear(hand.text()->at, {21, 50}));
    }
    void whatIsTypedIsRecoverable()
    {
        Writer hand;
        hand.click({20, 50});
        hand.type("LT");
        const auto pending = hand.canvas.pendingObject();
        QVERIFY(pending);
        const auto* text = std::get_if<app::TextRecipe>(&pending->object.particulars.recipe);
        QVERIFY(text && text->text == "LT");
        QVERIFY(!pending->replaces);
    }
    void whatIsTypedIntoATextIsRecoverable()
    {
        Writer hand;
        hand.click({20, 50});
        hand.type("L\n");
        hand.session.select({0});
        const app::Object before = hand.session.now().objects()[0].copy();
        hand.click(hand.path().start);
        QVERIFY(!hand.canvas.pendingObject()); // nothing has changed
        hand.type("LT");
        const auto pending = hand.canvas.pendingObject();
        QVERIFY(pending && pending->replaces == std::size_t(0));
        QCOMPARE(hand.session.history.count(), 1);
        hand.session.document.apply(app::keeping(hand.session.now(), *pending));
        QCOMPARE(hand.count(), std::size_t(1));
        QVERIFY(hand.written() == "LT" && hand.isDrawn());
        QVERIFY(hand.session.now().objects()[0].style() == before.style);
    }
    // Also a letter that has as many strokes as the one before it.
    void eachChangeIsToldToTheJournal()
    {
        Writer hand;
        hand.click({20, 50});
        hand.type("L");
        QString told;
        QObject::connect(&hand.canvas, &ui::Canvas::stepsChanged, &hand.canvas, [&] {
            if (const auto pending = hand.canvas.pendingObject())
                told = std::get<app::TextRecipe>(pending->object.particulars.recipe).text;
        });
        Hand::key(Qt::Key_Backspace);
        hand.type("V");
        QTRY_COMPARE(told, QString("V"));
        QTest::qWait(200);
        hand.field().selectAll();
        hand.type("L");
        QTRY_COMPARE(told, QString("L"));
    }
    void convertedItIsAPath()
    {
        Writer hand;
        hand.click({20, 50});
        hand.type("L\n");
        const auto before = hand.session.now().objects()[0].path();
        hand.session.select({0});
        Hand::key(Qt::Key_P, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(!hand.text() && hand.session.now().objects()[0].path() == before);
        QCOMPARE(hand.session.history.undoText(), "Convert to path");
        hand.session.history.undo();
        QVERIFY(hand.text());
    }
};

QTEST_MAIN(TextTest)
#include "text_test.moc"

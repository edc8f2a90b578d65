// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/add_and_remove.h"
#include "app/lettering/lettering.h"
#include "app/lettering/outline_fonts.h"
#include "app/lettering/stroke_fonts.h"
#include "app/session/units.h"
#include "app/view/outline.h"

#include <QComboBox>
#include <QInputMethodEvent>
#include <QLabel>
#include <QPlainTextEdit>
#include <QSignalSpy>
#include <QToolButton>

#include <algorithm>
#include <numbers>

#include "tests/test_class.h"
#include "tests/ui/tools/hand.h"

namespace tools_text_test {

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
        QComboBox& fonts() { return *field().parentWidget()->findChild<QComboBox*>(); }
        QString remark() { return field().parentWidget()->findChild<QLabel*>()->text(); }
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

    /// A font whose name types itself: no other one begins with the letter.
    static QString typableFont()
    {
        for (const QString& font : app::outlineFonts()) {
            const auto begins = [&](const QString& other) {
                return other.startsWith(font.front(), Qt::CaseInsensitive);
            };
            const bool stroke = std::ranges::any_of(
                app::strokeFonts(), [&](const app::StrokeFont& f) { return begins(f.name); });
            if (font.front().unicode() < 128 && font.front().isLetter() && !stroke
                && !app::lettered({"LT", font, 5, {}}).paths.empty()
                && *std::ranges::find_if(app::outlineFonts(), begins) == font)
                return font;
        }
        return {};
    }

private slots:
    void initTestCase() { QLocale::setDefault(QLocale::c()); }

    void theFieldStaysInsideTheCanvas()
    {
        Writer hand;
        hand.click({100, 50});
        hand.type("A");
        QWidget& box = *hand.field().parentWidget();
        const auto placed = [&] {
            hand.canvas.settle();
            return QRect(hand.surface().mapFromGlobal(box.mapToGlobal(QPoint(0, 0))), box.size());
        };
        const QRect usual = placed();
        QVERIFY(std::abs(usual.left() - hand.at({100, 50}).x()) <= 8);
        QVERIFY(usual.top() > hand.at({100, 50}).y()); // below the letters
        const QRect all = hand.surface().rect();
        const auto goTo = [&](const app::Point& place) {
            app::View view = hand.canvas.view();
            view.pan(place - view.toScreen({100, 50}));
            hand.canvas.go(view);
        };
        goTo({-30, -90});
        QCOMPARE(placed().topLeft(), all.topLeft());
        goTo({all.width() + 30.0, all.height() + 30.0});
        QCOMPARE(placed().right(), all.right());
        QVERIFY(all.contains(placed()));
    }

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
    void fontsStandBelowTheirHeadings()
    {
        Writer hand;
        hand.click({20, 50});
        const QComboBox& fonts = hand.fonts();
        const auto enabled = [&](int row) {
            return bool(fonts.model()->flags(fonts.model()->index(row, 0)) & Qt::ItemIsEnabled);
        };
        QCOMPARE(fonts.currentText(), app::strokeFonts().front().name);
        const int strokes = int(app::strokeFonts().size());
        QVERIFY(!enabled(0) && enabled(1) && enabled(strokes));
        QVERIFY(fonts.itemText(0).contains("plotters"));
        if (app::outlineFonts().isEmpty())
            QSKIP("no outline font is installed");
        QVERIFY(!enabled(strokes + 1) && enabled(strokes + 2));
        QCOMPARE(fonts.count(), strokes + 2 + int(app::outlineFonts().size()));
    }
    void aFontIsFoundByItsFirstLetter()
    {
        const QString font = typableFont();
        if (font.isEmpty())
            QSKIP("no outline font with Latin letters is installed");
        Writer hand;
        hand.click({20, 50});
        hand.type("LT");
        Hand::key(Qt::Key_Tab);
        const auto tool = hand.canvas.tool();
        QTest::keyClick(QApplication::focusWidget(), font.front().toLatin1());
        QCOMPARE(hand.fonts().currentText(), font);
        Hand::key(Qt::Key_Return); // back to the text
        Hand::key(Qt::Key_Return);
        QVERIFY(hand.count() == 1 && hand.canvas.tool() == tool);
        QVERIFY(hand.text()->font == font && hand.isDrawn());
        for (const app::Subpath& path : hand.paths())
            QVERIFY(path.closed);
        const auto style = hand.session.now().objects()[0].style();
        QVERIFY(style.fillRule == app::FillRule::NonZero);
        hand.click({100, 50}); // the font is kept for the next text
        hand.type("T\n");
        QCOMPARE(hand.text(1)->font, font);
        hand.session.select({0});
        hand.canvas.setTool("select");
        Hand::key(Qt::Key_C, Qt::ControlModifier);
        Hand::key(Qt::Key_V, Qt::ControlModifier);
        QVERIFY(hand.count() == 3 && hand.isDrawn(2));
    }
    void lettersInTheOpenListAreNoKeysOfTools()
    {
        Writer hand;
        hand.click({20, 50});
        hand.type("LT");
        Hand::key(Qt::Key_Tab);
        Hand::key(Qt::Key_Down, Qt::AltModifier);
        QWidget* const list = QApplication::activePopupWidget();
        QVERIFY(list);
        QTest::keyClick(list->focusWidget(), 'd'); // DejaVu Sans; on the canvas, the tool Pen
        QVERIFY(hand.canvas.tool() == "text" && list->isVisible());
        QTest::keyClick(list->focusWidget(), Qt::Key_Return);
        QTRY_COMPARE(hand.field().window()->focusWidget(), &hand.field());
        QCOMPARE(hand.fonts().currentText(), "DejaVu Sans");
        QCOMPARE(hand.field().toPlainText(), "LT");
    }
    // The fonts of the tests have bold letters, and no italic ones.
    void lettersAreBoldWhereTheFontHasThem()
    {
        Writer hand;
        hand.click({20, 50});
        hand.type("LT");
        QWidget& box = *hand.field().parentWidget();
        const auto face = [&box](const char* name) {
            for (auto* button : box.findChildren<QToolButton*>())
                if (button->accessibleName() == name)
                    return button;
            return static_cast<QToolButton*>(nullptr);
        };
        QVERIFY(!face("Bold")->isVisible() && !face("Italic")->isVisible()); // single strokes
        Hand::key(Qt::Key_I, Qt::ControlModifier); // elsewhere it inverts the selection
        QVERIFY(hand.session.selection().empty() && hand.field().hasFocus());
        hand.fonts().setCurrentIndex(hand.fonts().findData("DejaVu Sans"));
        QVERIFY(face("Bold")->isVisible() && !face("Italic")->isVisible());
        Hand::key(Qt::Key_I, Qt::ControlModifier);
        Hand::key(Qt::Key_B, Qt::ControlModifier);
        QVERIFY(face("Bold")->isChecked() && hand.field().hasFocus());
        Hand::key(Qt::Key_Return);
        const app::FontFace bold{.bold = true};
        QVERIFY(hand.text()->face == bold && hand.isDrawn());
        const auto letters = hand.paths();
        hand.session.select({});
        hand.canvas.setTool("text");
        hand.click({100, 50}); // kept for the next text
        hand.type("LT");
        QVERIFY(face("Bold")->isChecked());
        QTest::mouseClick(face("Bold"), Qt::LeftButton);
        Hand::key(Qt::Key_Return);
        QVERIFY(hand.text(1)->face == app::FontFace{} && hand.isDrawn(1));
        const auto width = [](const std::vector<app::Subpath>& paths) {
            return app::painterPath(paths, app::FillRule::NonZero).boundingRect().width();
        };
        QVERIFY(width(letters) > 1.05 * width(hand.session.now().objects()[1].path().subpaths()));
    }
    void aMissingFontIsNamedAndReplacedOnceTheTextChanges()
    {
        Writer hand;
        app::Objects objects = hand.session.now().objects().slice(0, 0);
        const app::TextRecipe before{"LT", "No such font", 5, {18, 50}};
        objects.append(app::Object{.path = app::Path(std::vector{corner()}),
                                   .style = {.stroke = app::Colour{}},
                                   .particulars = {.recipe = before}});
        hand.session.history.push(new app::AddObjects(hand.session.document, objects,
                                                      app::containerForNew(hand.session), "Text"));
        QSignalSpy refused(&hand.session, &app::Session::refused);
        hand.canvas.setTool("select");
        hand.doubleClick({60, 20});
        QCOMPARE(hand.field().toPlainText(), "LT");
        QVERIFY(hand.remark().contains("No such font"));
        QVERIFY(hand.fonts().currentIndex() < 0);
        QCOMPARE(hand.fonts().placeholderText(), "No such font");
        Hand::key(Qt::Key_Return);
        QVERIFY(hand.path() == corner() && *hand.text() == before);
        QVERIFY(hand.session.history.count() == 1 && refused.isEmpty());

        const QString instead = app::fontInsteadOf("No such font");
        hand.doubleClick({60, 20});
        hand.type("LV");
        QVERIFY(hand.remark().contains(instead));
        QCOMPARE(hand.fonts().currentText(), instead);
        Hand::key(Qt::Key_Return);
        QVERIFY(hand.text()->font == instead && hand.isDrawn());
        QVERIFY(refused.size() == 1 && refused[0][0].toString().contains("No such font"));
        hand.session.history.undo();
        QVERIFY(hand.path() == corner() && *hand.text() == before);
    }
    void aTurnedTextKeepsItsAngleWhenItIsEdited()
    {
        Writer hand;
        hand.click({60, 50});
        hand.type("LT\n");
        const app::Point at = hand.text()->at;
        hand.session.select({0});
        hand.canvas.setTool("select");
        hand.type("o30\n");
        QVERIFY(hand.text() && hand.isDrawn());
        const app::TextRecipe turned = *hand.text();
        QVERIFY(std::abs(turned.turn + std::numbers::pi / 6) < 1e-9 && turned.at != at);
        hand.doubleClick(hand.path().start);
        QCOMPARE(hand.field().toPlainText(), "LT");
        QVERIFY(hand.field().isVisible());
        hand.type("LTLT\n");
        QVERIFY(hand.written() == "LTLT" && hand.isDrawn());
        QVERIFY(hand.text()->turn == turned.turn && hand.text()->at == turned.at);
    }
    void aMirroredTextStaysAText()
    {
        Writer hand;
        hand.click({60, 50});
        hand.type("LT\n");
        hand.session.select({0});
        hand.canvas.setTool("select");
        Hand::key(Qt::Key_H, Qt::ShiftModifier);
        QVERIFY(hand.isDrawn() && hand.text()->mirrored);
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

} // namespace tools_text_test

TEST_CLASS(tools_text_test::TextTest, Widgets)
#include "tests/ui/tools/text_test.moc"

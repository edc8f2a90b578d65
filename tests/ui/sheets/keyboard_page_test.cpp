// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/keys_in_use.h"
#include "app/session/window_steps.h"
#include "ui/sheets/command_keys.h"
#include "ui/sheets/key_field.h"
#include "ui/sheets/key_model.h"
#include "ui/sheets/settings_sheet.h"

#include <QLabel>
#include <QPushButton>
#include <QTableView>
#include <QTextBrowser>
#include <QToolButton>

#include "tests/not_empty.h"
#include "tests/test_class.h"
#include "tests/ui/test_window.h"

namespace ui::sheets_keyboard_page_test {

using K = QKeySequence;
using Keys = QList<QKeySequence>;

namespace {

/// A window with the page *Keyboard* open.
class Page {
public:
    Page()
    {
        t.show();
        t.open(t.twoLines());
        t.run("settings");
        sheet().turnTo(SettingsSheet::Keyboard);
    }
    SettingsSheet& sheet() const { return static_cast<SettingsSheet&>(*t.window->sheet()); }
    template <class Part>
    Part* part(const char* name) const
    {
        return sheet().findChild<Part*>(QLatin1StringView(name));
    }
    QTableView& table() const { return *part<QTableView>("keys"); }
    KeyModel& model() const { return static_cast<KeyModel&>(*table().model()); }
    const app::KeyTable& keys() const { return CommandKeys::of(*t.window).table(); }
    std::size_t numberOf(const char* command) const
    {
        const auto& all = keys().commands();
        return std::size_t(std::ranges::find(all, QString(command), &app::KeyedCommand::key)
                           - all.begin());
    }
    void choose(const char* command) const { table().selectRow(model().rowOf(numberOf(command))); }
    void press(Qt::Key key, Qt::KeyboardModifiers with = {}) const
    {
        auto* field = part<KeyField>("new-key");
        field->setFocus();
        QTest::keyClick(field, key, with);
    }
    void click(const char* button) const { part<QPushButton>(button)->click(); }
    QString answer() const { return part<QLabel>("key-answer")->text(); }
    Keys keysOf(const char* command) const { return t.action(command)->shortcuts(); }

    TestWindow t;
};

} // namespace

class KeyboardPageTest : public QObject {
    Q_OBJECT

private slots:
    void everyCommandWithANameIsListedOnce()
    {
        const Page page;
        QStringList listed;
        for (int row = 0; row < page.model().rowCount(); ++row)
            if (const auto command = page.model().command(row))
                listed << page.keys().commands()[*command].key;
        QVERIFY(listed.size() > 150);
        QCOMPARE(listed.removeDuplicates(), 0);
        for (const char* key : {"save", "undo", "tool-line", "panel-layers", "unit-mm", "crop"})
            QVERIFY2(listed.contains(key), key);
    }

    /// Otherwise the table would begin with a key that does two things.
    void noTwoCommandsHaveTheSameStandardKey()
    {
        const Page page;
        for (std::size_t i = 0; i < page.keys().commands().size(); ++i)
            for (const K& key : page.keys().keys(i)) {
                const auto other = page.keys().holder(key, i);
                QVERIFY2(!other, qPrintable(page.keys().commands()[i].name + ' '
                                            + page.keys().commands()[other.value_or(0)].name));
            }
    }

    /// Otherwise *Reset* would give a command what the field refuses.
    void noStandardKeyOfTheCanvasIsRefused()
    {
        const Page page;
        for (std::size_t i = 0; i < page.keys().commands().size(); ++i)
            if (page.keys().commands()[i].scope == app::KeyedCommand::Scope::Canvas
                || page.keys().commands()[i].scope == app::KeyedCommand::Scope::ChosenWindow)
                for (const K& key : page.keys().commands()[i].standard) {
                    const QString why = page.keys().refusal(i, key);
                    QVERIFY2(why.isEmpty(), qPrintable(why));
                }
    }

    void aPressedKeyIsTheKeyOfTheCommandFromNowOn()
    {
        Page page;
        page.choose("split");
        page.press(Qt::Key_J, Qt::ControlModifier | Qt::AltModifier);
        QCOMPARE(page.keysOf("split"), Keys{K("Ctrl+Alt+J")});
        QCOMPARE(page.part<QLabel>("chosen-command")->text(),
                 QStringLiteral("Split at windows: Ctrl+Alt+J"));
        QCOMPARE(page.answer(), QString());
        page.t.run("shortcuts");
        const auto* help = page.t.window->findChild<QTextBrowser*>();
        QVERIFY(help->toPlainText().contains("Split at windows\nCtrl+Alt+J"));
        page.t.window = windowWithMenus(); // remembered
        QCOMPARE(page.keysOf("split"), Keys{K("Ctrl+Alt+J")});
    }

    void theNewKeyOfAToolWorksOnTheCanvas()
    {
        Page page;
        page.choose("tool-star");
        page.press(Qt::Key_F, Qt::ShiftModifier);
        QCOMPARE(page.keysOf("tool-star"), Keys{K("Shift+F")});
        QVERIFY(page.t.action("tool-star")->toolTip().contains("Shift+F"));
        page.t.window->canvas().setFocus();
        QTest::keyClick(page.t.drawingArea(), Qt::Key_S);
        QVERIFY(page.t.window->canvas().tool() == "select");
        QTest::keyClick(page.t.drawingArea(), Qt::Key_F, Qt::ShiftModifier);
        QVERIFY(page.t.window->canvas().tool() == "star");
    }

    void aKeyOfAnotherCommandIsOfferedAndTakenOver()
    {
        const Page page;
        page.choose("crop");
        page.press(Qt::Key_Z, Qt::ControlModifier);
        QCOMPARE(page.answer(), QStringLiteral("Ctrl+Z belongs to “Undo”."));
        QVERIFY(page.keysOf("undo").contains(K("Ctrl+Z")));
        QVERIFY(!page.part<QPushButton>("take-key")->isHidden());
        page.click("take-key");
        QCOMPARE(page.keysOf("crop"), Keys{K("Ctrl+Z")});
        QVERIFY(!page.keysOf("undo").contains(K("Ctrl+Z")));
        QVERIFY(page.answer().contains("“Undo”"));
        QVERIFY(page.part<QPushButton>("take-key")->isHidden());
    }

    /// As it opens: no command is chosen, and no key is offered.
    void thePageBeginsWithoutAnOffer()
    {
        const Page page;
        QVERIFY(page.part<QPushButton>("take-key")->isHidden());
        const Keys before = page.keysOf("undo");
        for (const char* button : {"take-key", "remove-keys", "reset-keys"})
            page.click(button);
        page.press(Qt::Key_J, Qt::ControlModifier);
        QVERIFY(page.keys().isStandard());
        QCOMPARE(page.keysOf("undo"), before);
        QCOMPARE(page.answer(), QString());
    }

    void anOfferEndsWithTheChoice()
    {
        const Page page;
        page.choose("crop");
        page.press(Qt::Key_Z, Qt::ControlModifier);
        page.choose("split");
        QVERIFY(page.part<QPushButton>("take-key")->isHidden());
        QCOMPARE(page.answer(), QString());
    }

    void aKeyThatCannotBeIsRefused()
    {
        const Page page;
        page.choose("save");
        for (const auto& [key, with] :
             {std::pair(Qt::Key_B, Qt::NoModifier), std::pair(Qt::Key_Space, Qt::NoModifier),
              std::pair(Qt::Key_F, Qt::AltModifier)}) {
            page.press(key, with);
            QVERIFY(page.answer().endsWith(u'.'));
            QVERIFY(page.part<QPushButton>("take-key")->isHidden());
            QCOMPARE(page.keysOf("save").front(), K("Ctrl+S"));
        }
        QVERIFY(page.answer().contains("the menu File"));
    }

    void theKeysOfAChosenWindowAreChanged()
    {
        const Page page;
        MainWindow& window = *page.t.window;
        app::Session& session = window.session();
        for (const double at : {10.0, 20.0})
            app::addWindow(session, {.shape = app::RectangleShape{{{at, at}, {at + 30, at + 30}}}});
        page.choose("window-cuts-out");
        page.press(Qt::Key_Slash);
        page.choose("keep-outside");
        page.press(Qt::Key_M, Qt::ControlModifier);
        window.closeSheet();
        window.canvas().setTool("window");
        session.chooseWindow(session.windows().list.size() - 1);
        window.canvas().setFocus();
        const auto operation = [&] { return session.windows().list.back().operation; };
        QTest::keyClick(page.t.drawingArea(), Qt::Key_Minus);
        QTest::keyClick(window.focusWidget(), Qt::Key_Escape); // what it may have begun
        QCOMPARE(operation(), app::WindowOperation::Add);
        session.chooseWindow(session.windows().list.size() - 1);
        QTest::keyClick(page.t.drawingArea(), Qt::Key_Slash);
        QCOMPARE(operation(), app::WindowOperation::CutOut);
        QTest::keyClick(page.t.drawingArea(), Qt::Key_M, Qt::ControlModifier);
        QCOMPARE(session.now().windows().keep, app::Keep::Outside);
        QStringList tips;
        for (const auto* button : window.canvas().findChildren<QToolButton*>())
            tips << button->toolTip();
        QVERIFY(tips.contains("Cut the window out of those above it (/)"));
    }

    /// Also in the middle of a gesture, where its command is not enabled.
    void theKeyOfATransformationIsChanged()
    {
        const Page page;
        MainWindow& window = *page.t.window;
        page.choose("move");
        page.press(Qt::Key_M);
        window.closeSheet();
        page.t.run("workspace-draw"); // digits are numbers
        window.canvas().setFocus();
        window.session().select({0});
        QTest::keyClick(page.t.drawingArea(), Qt::Key_M);
        QTest::keyClick(window.focusWidget(), '7');
        QTest::keyClick(window.focusWidget(), Qt::Key_Return);
        QCOMPARE(window.session().history.count(), 1);
        window.session().select({});
        QTest::keyClick(page.t.drawingArea(), Qt::Key_G);
        QVERIFY(!window.canvas().pendingObject());
        window.canvas().setTool("polyline");
        for (const QPoint at : {QPoint(60, 60), QPoint(160, 90)})
            QTest::mouseClick(page.t.drawingArea(), Qt::LeftButton, {}, at);
        QTest::keyClick(page.t.drawingArea(), Qt::Key_M); // ends it, and moves it
        QCOMPARE(window.session().history.count(), 2);
        QVERIFY(window.canvas().tool() == "select");
    }

    void aResetSaysWhichCommandsHaveTheirKeysAgain()
    {
        const Page page;
        page.choose("crop");
        page.press(Qt::Key_Z, Qt::ControlModifier);
        page.click("take-key");
        page.click("reset-keys");
        QVERIFY(page.keys().isStandard());
        QCOMPARE(page.answer(), QStringLiteral("“Undo” has Ctrl+Z again."));
        page.choose("split");
        page.press(Qt::Key_Z, Qt::ControlModifier);
        page.click("take-key");
        page.choose("undo");
        page.click("reset-keys");
        QCOMPARE(page.answer(), QStringLiteral("“Split at windows” no longer has Ctrl+Z."));
    }

    void keysAreRemovedAndReset()
    {
        const Page page;
        const Keys standard = page.keysOf("redo");
        QVERIFY(!page.part<QPushButton>("reset-keys")->isEnabled());
        page.choose("redo");
        page.click("remove-keys");
        QCOMPARE(page.keysOf("redo"), Keys());
        QVERIFY(!page.part<QPushButton>("remove-keys")->isEnabled());
        page.click("reset-keys");
        QCOMPARE(page.keysOf("redo"), standard);
        page.click("remove-keys");
        page.choose("group");
        page.press(Qt::Key_F10);
        page.click("reset-settings");
        QCOMPARE(page.keysOf("redo"), standard);
        QCOMPARE(page.keysOf("group"), Keys{K("Ctrl+G")});
        QVERIFY(QSettings().value("shortcuts").toStringList().isEmpty());
    }

    void commandsAreFoundByNameMenuAndKey()
    {
        const Page page;
        const auto found = [&page](const char* words) {
            page.part<QLineEdit>("find-key")->setText(words);
            QStringList names;
            for (int row = 0; row < page.model().rowCount(); ++row)
                if (page.model().command(row))
                    names << page.model().index(row, 0).data().toString();
            return names;
        };
        QCOMPARE(found("crop"), QStringList("Crop to windows"));
        QCOMPARE(found("ctrl+shift+x"), QStringList("Crop to windows"));
        QVERIFY(found("file sa").contains("Save as"));
        QCOMPARE(found("zzzz"), QStringList());
        QVERIFY(!page.part<KeyField>("new-key")->isEnabled());
        found("tiles");
        QTest::keyClick(page.part<QLineEdit>("find-key"), Qt::Key_Return);
        QVERIFY(page.table().hasFocus());
        QVERIFY(page.part<QLabel>("chosen-command")->text().startsWith("Tiles"));
        QVERIFY(found("").size() > 150);
    }

    void keysGoToTheFieldAndNotToCommands()
    {
        Page page;
        page.choose("split");
        const std::string tool(page.t.window->canvas().tool());
        page.press(Qt::Key_W);
        QCOMPARE(std::string(page.t.window->canvas().tool()), tool);
        page.press(Qt::Key_Shift, Qt::ShiftModifier); // waits
        QVERIFY(page.keysOf("split").isEmpty());
        QTest::keyClick(page.part<KeyField>("new-key"), Qt::Key_Escape);
        QVERIFY(page.table().hasFocus() && page.t.window->sheet());
        QTest::keyClick(&page.table(), Qt::Key_Return);
        QVERIFY(page.part<KeyField>("new-key")->hasFocus());
    }

    void sentencesNameTheKeysThatCommandsHave()
    {
        const Page page;
        const app::KeysInUse& named = app::standardKeysInSentences();
        for (const auto& [command, key] : notEmpty(named).asKeyValueRange()) {
            const QAction* action = page.t.window->findChild<QAction*>(command);
            QVERIFY2(action, qPrintable(command));
            QCOMPARE(action->shortcut(), K(key));
        }
        page.choose("tool-window");
        page.press(Qt::Key_F10);
        page.choose("next-difference");
        page.press(Qt::Key_F12, Qt::ShiftModifier);
        page.t.run("remove-window");
        QVERIFY(page.t.action("fit-window")->statusTip().contains("(F10)"));
        QStringList tips;
        for (const auto* button : page.t.window->findChildren<QToolButton*>())
            tips << button->toolTip();
        QVERIFY(tips.contains("Next difference (Shift+F12)"));
        page.click("reset-settings");
        QVERIFY(page.t.action("fit-window")->statusTip().contains("(W)"));
    }

    void garbageInTheSettingsIsToldOnce()
    {
        TestWindow t;
        QSettings().setValue("shortcuts", QStringList{"save\tnonsense", "?", "quit\tCtrl+J"});
        t.window = windowWithMenus();
        CommandKeys::of(*t.window).tellIgnored();
        QVERIFY(t.window->message().contains("keyboard shortcuts"));
        t.open(t.twoLines());
        QCoreApplication::processEvents();
        QCOMPARE(t.window->message(), QString());
        QVERIFY(t.action("save")->shortcuts().contains(K("Ctrl+S")));
        QCOMPARE(t.action("quit")->shortcuts(), Keys{K("Ctrl+J")});
    }
};

} // namespace ui::sheets_keyboard_page_test

TEST_CLASS(ui::sheets_keyboard_page_test::KeyboardPageTest, Widgets)
#include "tests/ui/sheets/keyboard_page_test.moc"

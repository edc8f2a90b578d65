// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/settings/usable_key.h"

#include <random>

#include "tests/test_class.h"

namespace app::settings_key_table_test {

using Scope = KeyedCommand::Scope;
using Keys = QList<QKeySequence>;
using K = QKeySequence;

class KeyTableTest : public QObject {
    Q_OBJECT

    enum : std::size_t { Save, Quit, Line, Invert, Outside };
    static std::vector<KeyedCommand> commands()
    {
        return {{"save", "Save", "File", Scope::Everywhere, {K("Ctrl+S"), K("F12")}},
                {"quit", "Quit", "File", Scope::Everywhere, {K("Ctrl+Q")}},
                {"line", "Line", "Draw", Scope::Canvas, {K("L")}},
                {"invert", "Invert", "Select", Scope::Everywhere, {}},
                {"outside", "Keep outside", "Clip", Scope::Fixed, {K("X")}}};
    }

private slots:
    void commandsBeginWithTheirStandardKeys()
    {
        const KeyTable table(commands());
        for (std::size_t i = 0; i < table.commands().size(); ++i)
            QCOMPARE(table.keys(i), commands()[i].standard);
        QVERIFY(table.isStandard());
        QCOMPARE(table.saved(), QStringList());
    }

    void aKeyIsGivenAndSaved()
    {
        KeyTable table(commands());
        table.give(Save, K("Ctrl+Alt+S"));
        QCOMPARE(table.keys(Save), Keys{K("Ctrl+Alt+S")});
        QVERIFY(!table.isStandard(Save) && table.isStandard(Quit));
        const KeyTable again(commands(), table.saved());
        QCOMPARE(again.keys(Save), table.keys(Save));
        QCOMPARE(again.ignored(), 0);
        table.reset(Save);
        QCOMPARE(table.saved(), QStringList());
    }

    void aTakenKeyBelongsToOneCommand()
    {
        KeyTable table(commands());
        QCOMPARE(table.holder(K("F12"), Quit), std::optional<std::size_t>(Save));
        QCOMPARE(table.holder(K("F12"), Save), std::nullopt);
        table.give(Quit, K("F12"));
        QCOMPARE(table.keys(Save), Keys{K("Ctrl+S")});
        QCOMPARE(table.keys(Quit), Keys{K("F12")});
        const KeyTable again(commands(), table.saved());
        QCOMPARE(again.keys(Save), table.keys(Save));
        QCOMPARE(again.keys(Quit), table.keys(Quit));
        const auto moves = table.reset(Save); // takes it back
        QCOMPARE(table.keys(Save), commands()[Save].standard);
        QCOMPARE(table.keys(Quit), Keys());
        QCOMPARE(moves.size(), std::size_t(1));
        QVERIFY(moves[0].command == Quit && moves[0].key == K("F12") && moves[0].isLost);
    }

    void aResetGivesTakenKeysBack()
    {
        KeyTable table(commands());
        table.give(Quit, K("Ctrl+S"));
        auto moves = table.reset(Quit);
        QCOMPARE(table.keys(Save), commands()[Save].standard); // in their order
        QVERIFY(table.isStandard());
        QCOMPARE(moves.size(), std::size_t(1));
        QVERIFY(moves[0].command == Save && moves[0].key == K("Ctrl+S") && !moves[0].isLost);
        table.give(Quit, K("Ctrl+S"));
        table.give(Save, K("F6")); // its only key
        moves = table.reset(Quit);
        QVERIFY(moves.empty());
        QCOMPARE(table.keys(Save), Keys{K("F6")});
        table.give(Save, K("Ctrl+Q"));
        table.give(Quit, K("Ctrl+S"));
        moves = table.reset(Save); // they were exchanged
        QCOMPARE(moves.size(), std::size_t(2));
        QVERIFY(table.isStandard());
    }

    void keysAreExchangedAndRemoved()
    {
        KeyTable table(commands());
        table.give(Save, K("Ctrl+Q"));
        table.give(Quit, K("Ctrl+S"));
        table.clear(Line);
        const KeyTable again(commands(), table.saved());
        QCOMPARE(again.keys(Save), Keys{K("Ctrl+Q")});
        QCOMPARE(again.keys(Quit), Keys{K("Ctrl+S")});
        QCOMPARE(again.keys(Line), Keys());
        QCOMPARE(again.ignored(), 0);
        table.reset();
        QVERIFY(table.isStandard());
    }

    void keysThatACommandCannotHave_data()
    {
        QTest::addColumn<std::size_t>("command");
        QTest::addColumn<QKeySequence>("key");
        QTest::addColumn<QString>("why");
        const auto row = [](const char* name, std::size_t command, const K& key, const char* why) {
            QTest::newRow(name) << command << key << QString(why);
        };
        row("none", Save, K(), "cannot be a shortcut");
        row("two", Save, K("Ctrl+K, Ctrl+S"), "cannot be a shortcut");
        row("Shift alone", Save, K(Qt::Key_Shift), "cannot be a shortcut");
        row("Esc", Line, K(Qt::Key_Escape), "everywhere");
        row("Shift+Tab", Line, K(Qt::SHIFT | Qt::Key_Tab), "everywhere");
        row("arrow", Line, K(Qt::ALT | Qt::Key_Left), "moves");
        row("digit", Line, K(Qt::Key_3), "Digits");
        row("number", Line, K("."), "begins a number");
        row("sum", Line, K("Shift++"), "begins a number");
        row("bracket", Line, K(Qt::SHIFT | Qt::Key_ParenLeft), "begins a number");
        row("point", Line, K("#"), "begins a point");
        row("Menu", Line, K(Qt::Key_Menu), "context menu");
        row("Shift+F10", Save, K("Shift+F10"), "context menu");
        row("dead key", Line, K(Qt::Key_Dead_Circumflex), "cannot be a shortcut");
        row("Compose", Line, K(Qt::Key_Multi_key), "cannot be a shortcut");
        row("Super", Save, K(Qt::Key_Super_L), "cannot be a shortcut");
        row("letter in fields", Save, K("B"), "fields");
        row("capital in fields", Save, K("Shift+B"), "fields");
        row("Delete in fields", Save, K(Qt::Key_Delete), "fields");
        row("of the canvas", Line, K("X"), "“Keep outside”");
        row("fixed command", Outside, K("Ctrl+B"), "“Keep outside”");
    }
    void keysThatACommandCannotHave()
    {
        QFETCH(std::size_t, command);
        QFETCH(QKeySequence, key);
        QFETCH(QString, why);
        KeyTable table(commands());
        const QString refusal = table.refusal(command, key);
        QVERIFY2(refusal.contains(why), qPrintable(refusal));
        QVERIFY(refusal.endsWith(u'.'));
        table.give(command, key);
        QVERIFY(table.isStandard());
    }

    void keysThatACommandCanHave()
    {
        KeyTable table(commands());
        for (const char* key :
             {"B", "Shift+B", "/", "Del", "Ctrl+1", "F5", "F10", "Ctrl+Left", "Ctrl++"}) {
            QVERIFY2(table.refusal(Line, K(key)).isEmpty(), key);
            table.give(Line, K(key));
            QCOMPARE(table.keys(Line), Keys{K(key)});
        }
        for (const char* key : {"Ctrl+B", "Alt+Del", "F5", "Ctrl+1", "Ctrl+Shift+Return"})
            QVERIFY2(table.refusal(Save, K(key)).isEmpty(), key);
    }

    // Signs begin numbers, but not while a clip window is chosen.
    void aChosenWindowMayHaveSigns()
    {
        for (const char* key : {"+", "-", "*", "=", ".", "B", "#"})
            QVERIFY2(whyNoShortcut(K(key), Scope::ChosenWindow).isEmpty(), key);
        for (const QKeySequence& key : {K("3"), K(Qt::Key_Escape), K(Qt::Key_Left)})
            QVERIFY(!whyNoShortcut(key, Scope::ChosenWindow).isEmpty());
    }

    void whatIsWrongInTheSettingsIsIgnored_data()
    {
        QTest::addColumn<QStringList>("saved");
        QTest::newRow("no command") << QStringList{"garbage", "", "\t", "\tCtrl+S"};
        QTest::newRow("no key") << QStringList{"save\tnonsense", "quit\t", "line\tEsc"};
        QTest::newRow("fixed") << QStringList{"outside\tCtrl+B", "outside"};
        QTest::newRow("of the canvas") << QStringList{"line\tX"};
        QTest::newRow("long") << QStringList{"save\t" + QString(10'000, u'S'),
                                             QString(10'000, u'\t')};
    }
    void whatIsWrongInTheSettingsIsIgnored()
    {
        QFETCH(QStringList, saved);
        const KeyTable table(commands(), saved);
        QVERIFY(table.isStandard());
        QCOMPARE(table.ignored(), int(saved.size()));
    }

    void whatIsTwiceInTheSettingsCountsOnce()
    {
        const KeyTable table(commands(), {"save\tF6", "quit\tF6", "save\tF8"});
        QCOMPARE(table.keys(Save), Keys{K("F6")});
        QCOMPARE(table.keys(Quit), commands()[Quit].standard);
        QCOMPARE(table.ignored(), 2);
    }

    void tooManyEntriesAreIgnored()
    {
        QStringList saved(3000, "save\tF6");
        const KeyTable table(commands(), saved);
        QCOMPARE(table.keys(Save), Keys{K("F6")});
        QCOMPARE(table.ignored(), 2999);
    }

    /// Whatever is done, no key has two commands, and what is saved is read as it was.
    void randomStepsKeepTheTableSound()
    {
        std::mt19937 random(1);
        KeyTable table(commands());
        const std::vector<K> all{K("Ctrl+S"), K("F12"), K("Ctrl+Q"), K("L"), K("X"), K("F5")};
        for (int i = 0; i < 2000; ++i) {
            const std::size_t command = random() % 5;
            switch (random() % 4) {
            case 0:
                table.clear(command);
                break;
            case 1:
                table.reset(command);
                break;
            default:
                table.give(command, all[random() % all.size()]);
            }
            for (const K& key : all) {
                int holders = 0;
                for (std::size_t each = 0; each < 5; ++each)
                    holders += table.keys(each).contains(key);
                QVERIFY(holders <= 1);
            }
            const KeyTable again(commands(), table.saved());
            QCOMPARE(again.ignored(), 0);
            for (std::size_t each = 0; each < 5; ++each)
                QCOMPARE(again.keys(each), table.keys(each));
        }
    }

    void keysAreWrittenAsOneReadsThem()
    {
        QCOMPARE(keysText({}), QString());
        QCOMPARE(keysText({K("Ctrl+S"), K(Qt::Key_F16), K("F12"), K("F5")}),
                 QStringLiteral("Ctrl+S or F12"));
    }
};

} // namespace app::settings_key_table_test

TEST_CLASS(app::settings_key_table_test::KeyTableTest, Gui)
#include "tests/app/settings/key_table_test.moc"

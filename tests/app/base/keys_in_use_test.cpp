// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/base/keys_in_use.h"

#include "tests/test_class.h"

namespace app::base_keys_in_use_test {

class KeysInUseTest : public QObject {
    Q_OBJECT

private slots:
    void cleanup() { tellKeysInUse(standardKeysInSentences()); }

    void aSentenceHasTheKeysThatCommandsHaveNow()
    {
        const QString sentence = QStringLiteral("Draw one first ({tool-window}).");
        QCOMPARE(withKeys(sentence), QStringLiteral("Draw one first (W)."));
        tellKeysInUse({{"tool-window", "Shift+W"}});
        QCOMPARE(withKeys(sentence), QStringLiteral("Draw one first (Shift+W)."));
        tellKeysInUse({});
        QCOMPARE(withKeys(sentence), QStringLiteral("Draw one first."));
    }

    void otherSentencesStayAsTheyAre()
    {
        for (const char* text : {"", "Draw one.", "{", "{}", "({})", "{Row} and {column", "( {x )"})
            QCOMPARE(withKeys(text), QString(text));
    }

    void aKeyIsNotReadAsANameOfACommand()
    {
        tellKeysInUse({{"move", "{"}, {"scale", "{move}"}});
        QCOMPARE(withKeys("{scale} ({scale}), {move}rotate}"),
                 QStringLiteral("{move} ({move}), {rotate}"));
    }

    void severalKeysStandInOneSentence()
    {
        tellKeysInUse({{"move", "G"}, {"scale", "{move}"}});
        QCOMPARE(withKeys("{move}, {rotate}: move, rotate ({move})."),
                 QStringLiteral("G, –: move, rotate (G)."));
    }
};

} // namespace app::base_keys_in_use_test

TEST_CLASS(app::base_keys_in_use_test::KeysInUseTest, Core)
#include "tests/app/base/keys_in_use_test.moc"

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/recovery/recorded_history.h"

#include <QSignalSpy>
#include <QTest>

#include "tests/app/commands/random_commands.h"
#include "tests/test_class.h"

namespace recovery_recorded_history_test {

using namespace app;

class RecordedHistoryTest : public QObject {
    Q_OBJECT

private slots:
    void isRestoredAndGoesOn()
    {
        EditedDocument document(RandomDocuments(1).document(50));
        History history;
        RandomCommands commands(document, 2);
        std::vector<Document> states{document.now()};
        for (int i = 0; i < 60; ++i) {
            history.push(commands.next());
            states.push_back(document.now());
        }
        history.setIndex(40);
        history.setClean();
        history.setIndex(45);

        EditedDocument again(document.now());
        History restored;
        QSignalSpy spy(&restored, &History::restored), clean(&restored, &History::cleanChanged);
        restore(restored, again, recorded(history, ~std::size_t(0)));
        QCOMPARE(spy.count(), 1);
        QCOMPARE(clean.count(), 1);
        QCOMPARE(restored.count(), 60);
        QCOMPARE(restored.index(), 45);
        QVERIFY(restored.cleanIndex() == 40 && !restored.isClean());
        QVERIFY(restored.bytes() > 0);
        for (const int index : {40, 0, 60, 17}) {
            restored.setIndex(index);
            QVERIFY(again.now() == states[std::size_t(index)]);
            QCOMPARE(restored.isClean(), index == 40);
            QCOMPARE(restored.undoText(), index > 0 ? history.text(index - 1) : QString());
        }
        restored.push(new RemoveObjects(again, {0}));
        QCOMPARE(restored.count(), 18);
        restored.undo();
        QVERIFY(again.now() == states[17]);
    }
    void keepsTheNewestDoneStepsAndAllUndoneOnes()
    {
        EditedDocument document(RandomDocuments(1).document(50));
        History history;
        RandomCommands commands(document, 2);
        for (int i = 0; i < 30; ++i)
            history.push(commands.next());
        history.setIndex(20);
        for (const std::size_t most : {std::size_t(0), history.bytes() / 4, history.bytes()}) {
            const RecordedHistory record = recorded(history, most);
            QCOMPARE(int(record.steps.size()) - record.index, 10);
            QCOMPARE(record.index == 0, most == 0);
            QCOMPARE(record.index == 20, most == history.bytes());
            for (int i = 0; i < record.index; ++i)
                QCOMPARE(record.steps[std::size_t(i)].text, history.text(20 - record.index + i));
        }
    }
};

} // namespace recovery_recorded_history_test

TEST_CLASS(recovery_recorded_history_test::RecordedHistoryTest, Core)
#include "tests/app/recovery/recorded_history_test.moc"

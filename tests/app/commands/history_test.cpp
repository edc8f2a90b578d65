// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/commands/history.h"

#include <QSignalSpy>
#include <QTest>

#include "tests/test_class.h"

namespace commands_history_test {

using namespace app;
using namespace std::chrono_literals;

namespace {

/// Adds a number to a text, and takes it away again.
class Write : public UndoCommand {
public:
    static constexpr CommandKind row{"write", "Writes a number"};

    Write(std::string& text, int number, Merging merging = Merging::Never, std::size_t size = 100,
          const QString& name = QStringLiteral("Write"))
        : UndoCommand(row, name, merging), text_(text), numbers_{char('0' + number)}, size_(size)
    {
    }
    void redo() override { text_ += numbers_; }
    void undo() override { text_.resize(text_.size() - numbers_.size()); }
    bool mergeWith(const UndoCommand& next) override
    {
        const auto& other = static_cast<const Write&>(next);
        if (&other.text_ != &text_)
            return false;
        numbers_ += other.numbers_;
        size_ = std::max(size_, other.size_);
        return true;
    }
    std::size_t bytes() const override { return size_; }

private:
    std::string& text_;
    std::string numbers_;
    std::size_t size_;
};

/// A history of which the test is the clock.
struct Desk {
    Desk()
    {
        history.setClock([this] { return now; });
    }
    void write(int number, std::size_t size = 100)
    {
        history.push(new Write(text, number, Merging::Never, size));
    }
    void type(int number, const QString& name = QStringLiteral("Type"))
    {
        history.push(new Write(text, number, Merging::WithLast, 100, name));
    }
    void wait(std::chrono::milliseconds time) { now += time; }

    std::string text;
    std::chrono::steady_clock::time_point now{};
    History history;
};

} // namespace

class HistoryTest : public QObject {
    Q_OBJECT

private slots:
    void stepsAreUndoneAndRedone()
    {
        Desk d;
        QVERIFY(!d.history.canUndo() && !d.history.canRedo() && d.history.undoText().isEmpty());
        for (int i = 1; i <= 5; ++i)
            d.write(i);
        QCOMPARE(d.text, "12345");
        QCOMPARE(d.history.undoText(), QString("Write"));
        d.history.undo();
        d.history.undo();
        QCOMPARE(d.text, "123");
        QCOMPARE(d.history.index(), 3);
        QCOMPARE(d.history.count(), 5);
        QCOMPARE(d.history.redoText(), QString("Write"));
        d.history.redo();
        QCOMPARE(d.text, "1234");
        d.write(6); // 5 can no longer be redone
        QCOMPARE(d.text, "12346");
        QVERIFY(!d.history.canRedo() && d.history.redoText().isEmpty());
        for (const int index : {0, 5, 2, -3, 99}) {
            d.history.setIndex(index);
            QCOMPARE(d.history.index(), std::clamp(index, 0, 5));
            QCOMPARE(d.text, std::string("12346").substr(0, std::size_t(d.history.index())));
        }
        d.history.redo(); // there is none
        QCOMPARE(d.text, "12346");
        QCOMPARE(d.history.text(4), QString("Write"));
        QVERIFY(d.history.text(5).isEmpty() && d.history.text(-1).isEmpty());
    }

    void quickStepsAreOne()
    {
        Desk d;
        for (const int number : {1, 2, 3}) {
            d.type(number);
            d.wait(999ms); // after the last, not after the first
        }
        QCOMPARE(d.history.count(), 1);
        d.history.undo();
        QCOMPARE(d.text, "");
        d.history.redo();
        QCOMPARE(d.text, "123");
        d.type(4); // redoing came in between
        QCOMPARE(d.history.count(), 2);
        d.wait(1000ms);
        d.type(5);
        QCOMPARE(d.history.count(), 3);
        d.type(6, "Paint"); // has another name
        QCOMPARE(d.history.count(), 4);
        d.write(7);
        d.type(8); // one that joins none came in between
        QCOMPARE(d.history.count(), 6);
        std::string other;
        d.history.push(new Write(other, 9, Merging::WithLast, 100, "Type"));
        QCOMPARE(d.history.count(), 7);
        d.history.setIndex(0);
        QCOMPARE(d.text + other, "");
    }

    void nothingJoinsTheStepThatWasUndoneTo()
    {
        Desk d;
        d.type(1);
        d.write(2);
        d.history.undo();
        d.type(3);
        QCOMPARE(d.history.count(), 2);
        d.history.undo();
        QCOMPARE(d.text, "1");
    }

    void nothingJoinsWhatWasSaved()
    {
        Desk d;
        d.type(1);
        d.history.setClean();
        d.type(2);
        QCOMPARE(d.history.count(), 2);
        QVERIFY(!d.history.isClean());
        d.history.undo();
        QVERIFY(d.history.isClean());
        QCOMPARE(d.text, "1");
        d.history.redo();
        d.history.resetClean(); // as after recovering
        d.type(3);
        QCOMPARE(d.history.count(), 3);
    }

    // A save takes time.
    void theCleanStateIsThatAtTheBeginningOfTheSave()
    {
        Desk d;
        QSignalSpy clean(&d.history, &History::cleanChanged);
        d.type(1);
        d.history.beginClean();
        d.type(2); // joins nothing
        QVERIFY(!d.history.isClean());
        d.history.endClean();
        QVERIFY(!d.history.isClean());
        d.history.undo();
        QVERIFY(d.history.isClean());
        d.history.beginClean();
        d.history.undo();
        d.write(3); // what is being saved can no longer be reached
        d.history.endClean();
        for (int index = 0; index <= d.history.count(); ++index) {
            d.history.setIndex(index);
            QVERIFY(!d.history.isClean());
        }
        QCOMPARE(clean, (QList<QVariantList>{{false}, {true}, {false}}));
        d.history.setLimit(1500);
        d.write(4, 1000);
        d.history.beginClean();
        d.write(5, 1000); // the steps before are forgotten
        d.history.endClean();
        d.history.undo();
        QVERIFY(d.history.isClean());
    }

    void cleanIsTheSavedState()
    {
        Desk d;
        QSignalSpy clean(&d.history, &History::cleanChanged);
        QVERIFY(d.history.isClean());
        d.write(1);
        QVERIFY(!d.history.isClean());
        d.write(2);
        d.history.setClean();
        d.history.setClean();
        d.history.undo();
        d.write(3); // the saved state can no longer be reached
        for (int index = 0; index <= 2; ++index) {
            d.history.setIndex(index);
            QVERIFY(!d.history.isClean());
        }
        QCOMPARE(clean, (QList<QVariantList>{{false}, {true}, {false}}));
        d.history.clear();
        QVERIFY(d.history.isClean());
        d.history.resetClean();
        QVERIFY(!d.history.isClean());
        d.history.clear(); // also without a single step
        QVERIFY(d.history.isClean());
    }

    void beyondTheLimitTheOldestGo()
    {
        Desk d;
        QSignalSpy forgot(&d.history, &History::forgot);
        d.history.setLimit(10'000);
        for (int i = 0; i < 9; ++i)
            d.write(i, 1000);
        QVERIFY(forgot.isEmpty() && d.history.bytes() > 9000 && d.history.bytes() <= 10'000);
        for (int i = 0; i < 9; ++i) {
            d.write(i, 1000);
            QVERIFY(d.history.bytes() <= d.history.limit());
        }
        const int kept = d.history.count();
        QVERIFY(kept >= 8 && kept <= 9);
        QCOMPARE(d.history.index(), kept);
        QCOMPARE(d.history.forgotten(), 18 - kept);
        QCOMPARE(forgot.size(), 18 - kept); // one by one
        d.history.setIndex(0);
        QCOMPARE(d.text, std::string("012345678012345678").substr(0, std::size_t(18 - kept)));
        d.history.setIndex(kept);
        d.write(9, 50'000); // the newest stays, however large
        QCOMPARE(d.history.count(), 1);
        QCOMPARE(forgot.last(), QVariantList{kept});
        d.history.undo();
        d.history.redo();
        QCOMPARE(d.text.back(), '9');
        d.history.clear();
        QCOMPARE(d.history.bytes(), std::size_t(0));
        QCOMPARE(d.history.forgotten(), 0);
    }

    void aSmallerLimitHoldsAtOnce()
    {
        Desk d;
        for (int i = 0; i < 9; ++i)
            d.write(i, 1000);
        d.history.undo(); // 8 are done
        d.history.setLimit(5000);
        QVERIFY(d.history.bytes() <= 5000);
        QCOMPARE(d.history.forgotten(), 9 - d.history.count());
        QVERIFY(d.history.canRedo());
        d.history.setLimit(0);
        QCOMPARE(d.history.index(), 1);
    }

    void mergedCommandsAreMeasured()
    {
        Desk d;
        d.history.setLimit(10'000);
        d.write(1, 4000);
        d.type(2);
        d.history.push(new Write(d.text, 3, Merging::WithLast, 8000, "Type"));
        QCOMPARE(d.history.count(), 1); // what joined has grown
        QVERIFY(d.history.bytes() >= 8000);
    }

    void aForgottenSavedStateIsNeverReached()
    {
        Desk d;
        d.history.setLimit(5000);
        d.write(1, 1000);
        d.write(2, 1000);
        d.history.setClean();
        d.write(3, 1000);
        d.write(4, 3000); // 1 and 2 go: the saved state is the first that can be reached
        QCOMPARE(d.history.forgotten(), 2);
        d.history.setIndex(0);
        QVERIFY(d.history.isClean());
        d.history.setIndex(2);
        d.write(5, 1000);
        QCOMPARE(d.history.forgotten(), 3);
        for (int index = 0; index <= d.history.count(); ++index) {
            d.history.setIndex(index);
            QVERIFY(!d.history.isClean());
        }
    }

    // Signals come when everything can be asked.
    void signalsTellOfTheNewState()
    {
        Desk d;
        d.history.setLimit(3000);
        int changes = 0;
        connect(&d.history, &History::indexChanged, &d.history, [&](int index) {
            QCOMPARE(index, d.history.index());
            QCOMPARE(d.history.canUndo(), index > 0);
            QVERIFY(d.history.bytes() <= d.history.limit());
            ++changes;
        });
        connect(&d.history, &History::cleanChanged, &d.history,
                [&](bool clean) { QCOMPARE(clean, d.history.isClean()); });
        for (int i = 0; i < 5; ++i)
            d.write(i, 1000);
        d.history.setIndex(0);
        d.history.clear();
        QCOMPARE(changes, 7);
    }
};

} // namespace commands_history_test

TEST_CLASS(commands_history_test::HistoryTest, None)
#include "tests/app/commands/history_test.moc"

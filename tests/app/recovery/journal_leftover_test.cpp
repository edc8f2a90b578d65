// SPDX-License-Identifier: GPL-3.0-or-later
// Journals as leftovers: which are offered, and what becomes of them.
#include "app/commands/add_objects.h"
#include "app/recovery/recover.h"

#include <QTest>

#include "tests/app/recovery/recorded_drawing.h"

using namespace app;

namespace {

void addLine(RecordedDrawing& drawing)
{
    EditedDocument& document = drawing.document;
    Objects line = document.now().objects().slice(0, 0);
    line.append(Object{Path({{0, 0}, {1, 2}}), {}});
    drawing.history.push(
        new AddObjects(document, line, document.now().containers().childrenOf(0)[0], "Add line"));
}

} // namespace

class JournalLeftoverTest : public QObject {
    Q_OBJECT

    QTemporaryDir home_;

    /// A journal of one line, whose program has ended.
    QString left() const
    {
        RecordedDrawing drawing(Document(), home_.path());
        drawing.journal.setOrigin({{"plan", "/a/plan.svg", {}}, {}});
        addLine(drawing);
        return drawing.journal.folder();
    }
    qsizetype files() const { return QDir(home_.path()).entryList({"*.journal*"}).size(); }

private slots:
    void init() { QCOMPARE(files(), 0); }
    void cleanup()
    {
        for (const QFileInfo& each : QDir(home_.path()).entryInfoList({"*.journal*"}))
            QDir(each.filePath()).removeRecursively();
    }

    void isOfferedWithItsNameAndTime()
    {
        const QString folder = left();
        auto found = claimLeftovers(home_.path());
        QCOMPARE(found.size(), std::size_t(1));
        QCOMPARE(found[0].file, folder);
        QCOMPARE(found[0].origin.name, "plan");
        QCOMPARE(found[0].origin.path, "/a/plan.svg");
        QVERIFY(std::abs(found[0].ended.secsTo(QDateTime::currentDateTime())) < 60);
        QVERIFY(claimLeftovers(home_.path()).empty()); // it has been claimed
        const auto recovered = recover(found[0]);
        QVERIFY(recovered);
        QCOMPARE(recovered.value->document.objects().size(), std::size_t(1));
        QCOMPARE(recovered.value->history.steps[0].text, "Add line");
        found.clear();
        QCOMPARE(claimLeftovers(home_.path()).size(), std::size_t(1));
    }
    void isNotOfferedWhileItsProgramRuns()
    {
        RecordedDrawing drawing(Document(), home_.path());
        addLine(drawing);
        QVERIFY(claimLeftovers(home_.path()).empty());
        QVERIFY(QFile::exists(drawing.journal.folder()));
    }
    void isRemovedWithoutUnsavedChanges()
    {
        {
            RecordedDrawing drawing(Document(), home_.path());
            addLine(drawing);
            drawing.history.setClean();
            drawing.journal.wait();
        }
        {
            RecordedDrawing drawing(Document(), home_.path());
            drawing.journal.wait();
        }
        QCOMPARE(files(), 2);
        QVERIFY(claimLeftovers(home_.path()).empty());
        QCOMPARE(files(), 0);
    }
    void isDiscarded()
    {
        left();
        auto found = claimLeftovers(home_.path());
        discard(found[0]);
        QCOMPARE(files(), 0);
    }
    void thatIsDamagedIsSetAside()
    {
        const QString folder = left();
        QFile base(baseFile(folder, 1));
        QVERIFY(base.open(QIODevice::ReadWrite));
        QVERIFY(base.seek(30) && base.write("x") == 1);
        base.close();
        auto found = claimLeftovers(home_.path());
        QCOMPARE(found.size(), std::size_t(1));
        const auto recovered = recover(found[0]);
        QVERIFY(!recovered);
        QVERIFY2(recovered.error.endsWith('.'), qPrintable(recovered.error));
        const QString aside = setAside(found[0]);
        QVERIFY(QFile::exists(baseFile(aside, 1)));
        QVERIFY(claimLeftovers(home_.path()).empty());
        QVERIFY(QFile::exists(aside));
    }
    void standsBesideSvgFilesByTime()
    {
        const QString svg = QDir(home_.path()).filePath("old.svg");
        QVERIFY(!writeLeftover(Document(), {"old", {}, {}}, svg));
        QTest::qWait(20);
        left();
        auto found = claimLeftovers(home_.path());
        QCOMPARE(found.size(), std::size_t(2));
        QCOMPARE(found[0].origin.name, "plan");
        QCOMPARE(found[1].origin.name, "old");
        QVERIFY(recover(found[1]));
        discard(found[1]);
    }
};

QTEST_GUILESS_MAIN(JournalLeftoverTest)
#include "journal_leftover_test.moc"

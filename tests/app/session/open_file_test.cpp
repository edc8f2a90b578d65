// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/open_file.h"

#include "app/session/session.h"

#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include "tests/test_class.h"

namespace session_open_file_test {

using namespace app;

class OpenFileTest : public QObject {
    Q_OBJECT

    QTemporaryDir folder_;

    QString file(const QString& name, const QByteArray& content) const
    {
        QFile out(folder_.filePath(name));
        return out.open(QIODevice::WriteOnly) && out.write(content) == content.size()
                   ? out.fileName()
                   : QString();
    }

private slots:
    void aDrawingComesWithTheBlocksOfItsLines()
    {
        const OpenedFile opened = openFile(
            file("a.svg", "<svg xmlns='http://www.w3.org/2000/svg' width='10' height='10'>"
                          "<path d='M1 2L8 9' stroke='#000'/></svg>"));
        QVERIFY2(opened.drawing, qPrintable(opened.drawing.error));
        QVERIFY(opened.blocks);
        Session session;
        session.load(*opened.drawing.value, {}, opened.blocks);
        QCOMPARE(session.scene.lines().size(), std::size_t(1));
    }
    void whatCannotBeOpenedIsNamed_data()
    {
        QTest::addColumn<QString>("path");
        QTest::newRow("missing") << folder_.filePath("missing.svg");
        QTest::newRow("folder") << folder_.path();
        QTest::newRow("empty") << file("empty.svg", {});
        QTest::newRow("broken") << file("broken.svg", "<svg xmlns='http://www.w3.org/2000/svg'");
        QTest::newRow("another format") << file("song.mp3", "ID3");
    }
    void whatCannotBeOpenedIsNamed()
    {
        QFETCH(QString, path);
        const OpenedFile opened = openFile(path);
        QVERIFY(!opened.drawing && !opened.blocks);
        QVERIFY2(opened.drawing.error.contains(path), qPrintable(opened.drawing.error));
    }
};

} // namespace session_open_file_test

TEST_CLASS(session_open_file_test::OpenFileTest, Core)
#include "tests/app/session/open_file_test.moc"

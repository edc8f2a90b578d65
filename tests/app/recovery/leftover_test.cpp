// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/formats/format.h"
#include "app/recovery/leftover.h"

#include <QDir>
#include <QFile>
#include <QTemporaryDir>
#include <QTest>

#include <random>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/app/document/sheet.h"
#include "tests/app/formats/lossy.h"
#include "tests/test_class.h"

namespace recovery_leftover_test {

using namespace app;

class LeftoverTest : public QObject {
    Q_OBJECT

private slots:
    void whatIsWrittenComesBack()
    {
        const QTemporaryDir home;
        const QString folder = home.filePath("a/b/unsaved");
        const QDateTime time = QDateTime::fromMSecsSinceEpoch(1'700'000'000'123);
        const std::vector<Origin> origins{{"plan.svg", "/tmp/plan.svg", time},
                                          {"Guilloche rosette", {}, {}},
                                          {QString::fromUtf8("a \"b\" <c>&?>--%20\n→ ü.svg"),
                                           QString::fromUtf8("/x/%?>\"ü"), time},
                                          {QString(4000, u'ü'), "/" + QString(4000, u'ü'), time}};
        for (const Origin& origin : origins)
            QCOMPARE(writeLeftover(app::documentOf(sheet()), origin,
                                   folder + QString("/%1.svg").arg(++files_)),
                     std::nullopt);
        auto found = claimLeftovers(folder);
        QCOMPARE(found.size(), origins.size());
        for (const Origin& origin : origins) {
            const auto same = std::ranges::find(found, origin, &Leftover::origin);
            QVERIFY2(same != found.end(), qPrintable(origin.name.left(40)));
            const auto read = readFile(same->file);
            QVERIFY2(read, qPrintable(read.error));
            QVERIFY(app::sheetOf(read.value->document) == sheet() && !isLossy(*read.value));
            QVERIFY(same->ended.secsTo(QDateTime::currentDateTime()) < 3600);
        }
        QVERIFY(std::ranges::is_sorted(found, std::greater(), &Leftover::ended));
        const auto mode = QFile(folder).permissions();
        QVERIFY(!(mode & (QFile::ReadGroup | QFile::ReadOther)));
        for (Leftover& leftover : found)
            discard(leftover);
        QVERIFY(QDir(folder).isEmpty());
    }
    void onlyTheUserCanReadItInAnOpenFolderToo()
    {
        const QTemporaryDir home;
        const QByteArray folder = QFile::encodeName(home.filePath("open"));
        QCOMPARE(::mkdir(folder.constData(), 0755), 0);
        QCOMPARE(::chmod(folder.constData(), 0755), 0); // whatever the umask is
        const QString path = QFile::decodeName(folder) + "/x.svg";
        QCOMPARE(writeLeftover(app::documentOf(sheet()), {"x", {}, {}}, path), std::nullopt);
        struct stat found {};
        for (const QByteArray& each : {folder, QFile::encodeName(path)}) {
            QCOMPARE(::stat(each.constData(), &found), 0);
            QVERIFY2((found.st_mode & 0077) == 0, each.constData());
        }
    }
    void onlyOneProcessOffersIt()
    {
        const QTemporaryDir folder;
        QCOMPARE(writeLeftover(app::documentOf(sheet()), {"x", {}, {}}, folder.filePath("x.svg")),
                 std::nullopt);
        {
            const auto mine = claimLeftovers(folder.path());
            QCOMPARE(mine.size(), std::size_t(1));
            QVERIFY(claimLeftovers(folder.path()).empty());
        }
        QCOMPARE(claimLeftovers(folder.path()).size(), std::size_t(1)); // left for the next start
        const pid_t other = fork(); // which claims it and is killed
        if (other == 0) {
            const auto claimed = claimLeftovers(folder.path());
            _exit(int(claimed.size()));
        }
        int status = 0;
        waitpid(other, &status, 0);
        QCOMPARE(WEXITSTATUS(status), 1);
        QVERIFY(QFile::exists(folder.filePath("x.svg.lock")));
        QCOMPARE(claimLeftovers(folder.path()).size(), std::size_t(1));
    }
    void garbageIsLeftAlone()
    {
        const QTemporaryDir folder;
        const QString whole = folder.filePath("whole.svg");
        QCOMPARE(writeLeftover(app::documentOf(sheet()), {"whole", {}, {}}, whole), std::nullopt);
        QFile file(whole);
        QVERIFY(file.open(QIODevice::ReadOnly));
        const QByteArray bytes = file.readAll();
        const auto write = [&](const QString& name, const QByteArray& content) {
            QFile out(folder.filePath(name));
            QVERIFY(out.open(QIODevice::WriteOnly));
            out.write(content);
        };
        for (qsizetype size = 0; size + 1 < bytes.size(); size += size + 40 < bytes.size() ? 7 : 1)
            write(QString("cut%1.svg").arg(size), bytes.first(size));
        std::mt19937 random(3);
        for (int i = 0; i < 20; ++i) {
            QByteArray noise(int(random() % 5000), '\0');
            for (char& c : noise)
                c = char(random());
            write(QString("noise%1.svg").arg(i), noise);
        }
        write("other.svg", "<svg xmlns='http://www.w3.org/2000/svg'/>");
        write("notes.txt", bytes);
        QVERIFY(QDir(folder.path()).mkdir("folder.svg"));
        QCOMPARE(mkfifo(qPrintable(folder.filePath("pipe.svg")), 0600), 0); // opening it would wait
        QCOMPARE(symlink("loop.svg", qPrintable(folder.filePath("loop.svg"))), 0);
        const QStringList before = everything(folder.path());
        {
            const auto found = claimLeftovers(folder.path());
            QCOMPARE(found.size(), std::size_t(1));
            QCOMPARE(found[0].origin.name, "whole");
        }
        QCOMPARE(everything(folder.path()), before);
    }
    void whatCannotBeReadIsKeptButNotOfferedAgain()
    {
        const QTemporaryDir folder;
        const QString path = folder.filePath("x.svg");
        QCOMPARE(writeLeftover(app::documentOf(sheet()), {"x", {}, {}}, path), std::nullopt);
        QFile file(path);
        QVERIFY(file.open(QIODevice::ReadWrite));
        file.write("garbage"); // the end still says what it was
        file.close();
        auto found = claimLeftovers(folder.path());
        QCOMPARE(found.size(), std::size_t(1));
        QVERIFY(!readFile(found[0].file));
        const QString aside = setAside(found[0]);
        QVERIFY(QFile::exists(aside) && !QFile::exists(path));
        QVERIFY(claimLeftovers(folder.path()).empty());
    }
    void whereItCannotBeWrittenItSaysSo()
    {
        const auto error =
            writeLeftover(app::documentOf(sheet()), {"x", {}, {}}, "/dev/null/unsaved/x.svg");
        QVERIFY(error && error->startsWith("Cannot write /dev/null/unsaved/x.svg: "));
        QVERIFY(claimLeftovers("/dev/null/unsaved").empty());
    }
    void theFolderIsTheUsersState()
    {
        qputenv("XDG_STATE_HOME", "/some/state");
        QCOMPARE(leftoverFolder(), "/some/state/clearcut/unsaved");
        for (const char* const none : {"", "relative"}) {
            qputenv("XDG_STATE_HOME", none);
            QCOMPARE(leftoverFolder(), QDir::homePath() + "/.local/state/clearcut/unsaved");
        }
    }

private:
    static Sheet sheet()
    {
        Sheet sheet;
        sheet.layers = {{"Ground"}, {"Hidden", false, false}, {"Locked", true, true}};
        for (std::uint32_t layer = 0; layer < 3; ++layer) {
            Shape shape;
            shape.paths.push_back({{0.1, 1.0 / 3}, {{{double(layer), 7}}}, false});
            shape.style.stroke = Colour{1, 2, 3};
            shape.layer = layer;
            sheet.shapes.push_back(shape);
        }
        sheet.window = {{1, 2}, {30, 40}};
        return sheet;
    }
    static QStringList everything(const QString& folder)
    {
        return QDir(folder).entryList(QDir::AllEntries | QDir::System | QDir::Hidden
                                      | QDir::NoDotAndDotDot);
    }
    int files_ = 0;
};

} // namespace recovery_leftover_test

TEST_CLASS(recovery_leftover_test::LeftoverTest, Core)
#include "tests/app/recovery/leftover_test.moc"

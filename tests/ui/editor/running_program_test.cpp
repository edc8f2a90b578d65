// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor/running_program.h"

#include <QFile>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>
#include <QThread>

#include <sys/socket.h>
#include <sys/un.h>
#include <unistd.h>

#include "tests/test_class.h"

namespace editor_running_program_test {

using namespace ui;

namespace {

/// Hands over from a thread of its own, as another process does.
HandedOver handOverFromOutside(const QString& socket, const QStringList& files)
{
    HandedOver end = HandedOver::Refused;
    const std::unique_ptr<QThread> other(QThread::create([&] { end = handOver(socket, files); }));
    other->start();
    while (!other->isFinished())
        QTest::qWait(5);
    return end;
}

} // namespace

class RunningProgramTest : public QObject {
    Q_OBJECT

private slots:
    void filesAreHandedOver()
    {
        const QTemporaryDir folder;
        const QString socket = folder.filePath("socket");
        QVERIFY(handOver(socket, {"/a.svg"}) == HandedOver::NobodyIsThere);
        Listener listener(socket);
        QSignalSpy wanted(&listener, &Listener::wanted);
        const QStringList files{"/a b.svg", QString::fromUtf8("/ü/€.svg")};
        QVERIFY(handOverFromOutside(socket, files) == HandedOver::Taken);
        QCOMPARE(wanted.size(), 1);
        QCOMPARE(wanted[0][0].toStringList(), files);
        QVERIFY(handOverFromOutside(socket, {}) == HandedOver::Taken);
        QCOMPARE(wanted.size(), 2);
        QVERIFY(!(QFile::permissions(socket) & (QFile::ReadOther | QFile::WriteOther)));
    }

    void whatACrashLeftIsReplaced()
    {
        const QTemporaryDir folder;
        const QString socket = folder.filePath("socket");
        QFile file(socket);
        QVERIFY(file.open(QIODevice::WriteOnly));
        file.close();
        QVERIFY(handOver(socket, {}) == HandedOver::NobodyIsThere);
        const Listener listener(socket);
        QVERIFY(handOverFromOutside(socket, {}) == HandedOver::Taken);
    }

    void whoIsBeingQuitTakesNothing()
    {
        const QTemporaryDir folder;
        const QString socket = folder.filePath("socket");
        Listener listener(socket);
        QSignalSpy wanted(&listener, &Listener::wanted);
        listener.setAccepting([] { return false; });
        QVERIFY(handOverFromOutside(socket, {"/x.svg"}) == HandedOver::Refused);
        QCOMPARE(wanted.size(), 0);
    }

    void nonsenseIsRefused_data()
    {
        QTest::addColumn<QByteArray>("bytes");
        QTest::newRow("nothing") << QByteArray();
        QTest::newRow("text") << QByteArray("GET / HTTP/1.1\r\n\r\n");
        QTest::newRow("long list") << QByteArray::fromHex("636C6331FFFFFFFE");
        QTest::newRow("long text") << QByteArray::fromHex("636C633100000001FFFFFFFE") + "abc";
        QTest::newRow("relative") << QByteArray::fromHex("636C633100000001000000020061");
        QTest::newRow("much") << QByteArray(3'000'000, 'x');
    }
    void nonsenseIsRefused()
    {
        QFETCH(QByteArray, bytes);
        const QTemporaryDir folder;
        const QString socket = folder.filePath("socket");
        Listener listener(socket);
        QSignalSpy wanted(&listener, &Listener::wanted);
        const int there = ::socket(AF_UNIX, SOCK_STREAM | SOCK_NONBLOCK, 0);
        sockaddr_un place{};
        place.sun_family = AF_UNIX;
        qstrncpy(place.sun_path, qPrintable(socket), sizeof place.sun_path);
        QCOMPARE(::connect(there, reinterpret_cast<const sockaddr*>(&place), sizeof place), 0);
        QVERIFY(::send(there, bytes.data(), std::size_t(bytes.size()), MSG_NOSIGNAL) >= 0);
        QTest::qWait(50);
        ::close(there);
        QVERIFY(handOverFromOutside(socket, {"/good.svg"}) == HandedOver::Taken);
        QCOMPARE(wanted.size(), 1);
    }

    void foldersOfOthersAreNotUsed()
    {
        const QTemporaryDir folder; // the user's alone
        const QString socket = socketIn(folder.path(), "xcb:1");
        QVERIFY(socket.startsWith(folder.path() + '/'));
        QCOMPARE(socketIn(folder.path(), "xcb:1"), socket);
        QVERIFY(socketIn(folder.path(), "xcb:2") != socket);
        QVERIFY(socketIn({}, "xcb:1").isEmpty());
        QVERIFY(socketIn(folder.filePath("none"), "xcb:1").isEmpty());
        const auto mine = QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner;
        for (const auto others : {QFile::ReadGroup, QFile::ExeOther, QFile::WriteOther}) {
            QVERIFY(QFile::setPermissions(folder.path(), mine | others));
            QVERIFY(socketIn(folder.path(), "xcb:1").isEmpty());
        }
    }
};

} // namespace editor_running_program_test

TEST_CLASS(editor_running_program_test::RunningProgramTest, Gui)
#include "tests/ui/editor/running_program_test.moc"

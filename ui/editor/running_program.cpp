// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/editor/running_program.h"

#include "app/base/read_strings.h"

#include <QCryptographicHash>
#include <QDataStream>
#include <QDir>
#include <QFileInfo>
#include <QGuiApplication>
#include <QLocalServer>
#include <QLocalSocket>
#include <QTimer>

#include <unistd.h>

namespace ui {

namespace {

constexpr int patience = 2000;          // milliseconds
constexpr qint64 mostBytes = 1'000'000; // of a message
constexpr quint32 leastOfFile = 4;      // bytes of a name
constexpr quint32 sign = 0x636C6331;    // "clc1": this form of a message
constexpr char acknowledgement = '\x06';

bool isPrivate(const QFileInfo& folder)
{
    constexpr auto others = QFile::ReadGroup | QFile::WriteGroup | QFile::ExeGroup
                            | QFile::ReadOther | QFile::WriteOther | QFile::ExeOther;
    return folder.isDir() && folder.ownerId() == getuid() && !(folder.permissions() & others);
}

} // namespace

QString socketIn(const QString& folder, const QByteArray& display)
{
    if (folder.isEmpty() || !isPrivate(QFileInfo(folder)))
        return {};
    constexpr int digits = 8; // a socket's path has at most 107 letters
    return QDir(folder).filePath(
        QStringLiteral("clearcut-")
        + QString::fromLatin1(
            QCryptographicHash::hash(display, QCryptographicHash::Sha256).toHex().left(digits)));
}

QString socketOfProgram()
{
    const QString platform = QGuiApplication::platformName();
    if (platform != QStringLiteral("xcb") && platform != QStringLiteral("wayland"))
        return {};
    return socketIn(qEnvironmentVariable("XDG_RUNTIME_DIR"),
                    platform.toUtf8() + qgetenv("DISPLAY") + qgetenv("WAYLAND_DISPLAY"));
}

HandedOver handOver(const QString& socket, const QStringList& files)
{
    if (socket.isEmpty())
        return HandedOver::NobodyIsThere;
    QLocalSocket there;
    there.connectToServer(socket);
    if (!there.waitForConnected(patience))
        return HandedOver::NobodyIsThere;
    QDataStream stream(&there);
    stream.setVersion(QDataStream::Qt_6_4);
    stream << sign << files;
    there.flush();
    char answer = 0;
    const bool taken =
        there.waitForReadyRead(patience) && there.getChar(&answer) && answer == acknowledgement;
    return taken ? HandedOver::Taken : HandedOver::Refused;
}

bool isSomebodyAt(const QString& socket)
{
    QLocalSocket there;
    if (!socket.isEmpty())
        there.connectToServer(socket);
    return there.waitForConnected(patience);
}

Listener::Listener(const QString& socket, QObject* parent)
    : QObject(parent), server_(std::make_unique<QLocalServer>())
{
    if (socket.isEmpty())
        return;
    connect(server_.get(), &QLocalServer::newConnection, this, &Listener::answer);
    server_->setSocketOptions(QLocalServer::UserAccessOption);
    QLocalServer::removeServer(socket);
    server_->listen(socket);
}

Listener::~Listener() = default;

void Listener::answer()
{
    while (QLocalSocket* from = server_->nextPendingConnection()) {
        from->setReadBufferSize(mostBytes);
        connect(from, &QLocalSocket::disconnected, from, &QObject::deleteLater);
        QTimer::singleShot(patience, from, &QLocalSocket::abort);
        const auto read = [this, from] {
            QDataStream stream(from);
            stream.setVersion(QDataStream::Qt_6_4);
            stream.startTransaction();
            quint32 form = 0;
            stream >> form;
            if (stream.status() == QDataStream::Ok && form != sign)
                return from->abort();
            const QStringList files = app::readStrings(stream, mostBytes / leastOfFile);
            if (stream.status() == QDataStream::ReadCorruptData)
                return from->abort();
            if (!stream.commitTransaction())
                return; // the rest is still to come, or the timer ends it
            if (accepting_ && !accepting_())
                return from->abort();
            from->putChar(acknowledgement);
            from->flush();
            from->disconnectFromServer();
            for (const QString& file : files)
                if (!QDir::isAbsolutePath(file))
                    return;
            emit wanted(files);
        };
        connect(from, &QLocalSocket::readyRead, from, read);
        read();
    }
}

} // namespace ui

#include "moc_running_program.cpp"

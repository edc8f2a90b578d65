// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/lesson_files.h"

#include "app/base/text.h"
#include "app/lessons/check_lesson.h"

#include <QCryptographicHash>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QImageReader>
#include <QStringDecoder>

#include <algorithm>

namespace app {

namespace {

constexpr qint64 mostBytes = 1'000'000, mostPictureBytes = 5'000'000;
constexpr int mostPixels = 4096; // of a picture's side
constexpr qsizetype mostFiles = 100;

LessonFile refused(const QString& path, const QString& why)
{
    return {.path = path, .faults = {{0, why}}};
}

/// Empty, or why a path is no file with bytes: a device or pipe would never end.
std::optional<QString> faultOfPath(const QString& path, qint64 most)
{
    const QFileInfo info(path);
    if (!info.exists())
        return info.isSymLink() ? Text::tr("This link leads nowhere.")
                                : Text::tr("There is no such file.");
    if (!info.isFile())
        return Text::tr("This is neither a file nor a folder.");
    if (info.size() > most)
        return Text::tr("It has %L1 kB; at most %L2 kB are read.")
            .arg(info.size() / 1000)
            .arg(most / 1000);
    return std::nullopt;
}

/// The text of a file, or why it has none.
Result<QString> textOf(const QString& path)
{
    if (const auto fault = faultOfPath(path, mostBytes))
        return Result<QString>::failure(*fault);
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return Result<QString>::failure(Text::tr("It cannot be read: %1.").arg(file.errorString()));
    const QByteArray bytes = file.read(mostBytes + 1);
    if (file.error() != QFileDevice::NoError)
        return Result<QString>::failure(Text::tr("It cannot be read: %1.").arg(file.errorString()));
    // Stateless: a sign that the end cuts off is an error, too.
    QStringDecoder decoder(QStringDecoder::Utf8, QStringDecoder::Flag::Stateless);
    QString text = decoder(bytes);
    if (bytes.contains('\0') || decoder.hasError())
        return Result<QString>::failure(Text::tr("This is no text in UTF-8."));
    return Result<QString>::of(std::move(text));
}

/// Empty, or why a picture beside the lesson cannot be shown.
std::optional<QString> faultOfPicture(const QString& name, const QString& path)
{
    if (name.contains(u'/') || name.startsWith(u'.'))
        return Text::tr("A picture lies beside the lesson's file: its name has no folder.");
    if (const auto fault = faultOfPath(path, mostPictureBytes))
        return Text::tr("The picture %1 is not shown: %2").arg(name.left(60), *fault);
    QImageReader reader(path, "png");
    const QSize size = reader.size();
    if (!reader.canRead() || size.isEmpty() || std::max(size.width(), size.height()) > mostPixels)
        return Text::tr("The picture %1 is not shown: it is no PNG picture of at most %2 × %2 "
                        "pixels.")
            .arg(name.left(60))
            .arg(mostPixels);
    return std::nullopt;
}

bool isSample(const QString& key)
{
    QFile index(QStringLiteral(":/samples/index.txt"));
    return index.open(QIODevice::ReadOnly) && index.readAll().contains('\n' + key.toUtf8() + '\t');
}

/// Makes a page's picture a path that can be shown, or leaves it out.
std::optional<QString> findPicture(LessonPage& page, const QString& folder)
{
    if (page.picture.isEmpty() || isSample(page.picture))
        return std::nullopt;
    const QString name = std::exchange(page.picture, QString());
    if (!name.endsWith(u".png", Qt::CaseInsensitive))
        return Text::tr("There is no sample “%1”, and a picture of your own ends with .png.")
            .arg(name.left(60));
    const QString path = QDir(folder).absoluteFilePath(name);
    auto fault = faultOfPicture(name, path);
    if (!fault)
        page.picture = path;
    return fault;
}

/// The name under which results of the lesson are kept.
QString resultKeyOf(const Lesson& lesson)
{
    QCryptographicHash hash(QCryptographicHash::Sha1);
    const auto add = [&](const QString& text) { hash.addData(text.toUtf8() + '\n'); };
    add(lesson.title);
    for (const LessonPage& page : lesson.pages)
        if (page.question) {
            const auto& [a, b] = page.tracedLine.line;
            const auto& [min, max] = page.tracedLine.window;
            add(page.question->kind + u' ' + page.question->words.join(u' '));
            add(keyOf(page.tracedLine.variant) + u' ' + page.families.join(u' ') + u' '
                + page.step);
            for (const double x : {a.x, a.y, b.x, b.y, min.x, min.y, max.x, max.y})
                add(QString::number(x, 'g', 17));
        }
    return QStringLiteral("file-") + QString::fromLatin1(hash.result().toHex().first(16));
}

LessonFile readLessonFile(const QString& path)
{
    const auto text = textOf(path);
    if (!text)
        return refused(path, text.error);
    ParsedLesson parsed = parseLesson({}, *text.value);
    LessonFile file{.path = path, .faults = std::move(parsed.faults)};
    if (file.faults.empty())
        file.faults = faultsOf(parsed);
    const bool teaches = std::ranges::none_of(file.faults, &LessonFault::prevents);
    for (std::size_t i = 0; i < parsed.lesson.pages.size(); ++i)
        if (const auto fault = findPicture(parsed.lesson.pages[i], QFileInfo(path).path()))
            file.faults.push_back({parsed.lines[i].picture, *fault, false});
    std::ranges::stable_sort(file.faults, {}, &LessonFault::line);
    parsed.lesson.key = resultKeyOf(parsed.lesson);
    if (teaches)
        file.lesson = std::move(parsed.lesson);
    return file;
}

/// The lesson files of a folder, or the folder with what is wrong with it.
std::vector<LessonFile> filesIn(const QString& folder)
{
    const QDir dir(folder);
    if (!QFileInfo(folder).isReadable())
        return {refused(folder, Text::tr("This folder cannot be read."))};
    // System: links that lead nowhere are told of, too.
    QStringList names = dir.entryList({QStringLiteral("*.md")},
                                      QDir::Files | QDir::System | QDir::Hidden, QDir::Name);
    names.removeIf([](const QString& name) {
        return name.startsWith(u'.') || name.compare(u"README.md", Qt::CaseInsensitive) == 0;
    });
    if (names.isEmpty())
        return {refused(folder, Text::tr("There is no lesson (NAME.md) in this folder."))};
    std::vector<LessonFile> files;
    for (const QString& name : names.first(std::min(names.size(), mostFiles)))
        files.push_back({.path = dir.filePath(name)});
    if (names.size() > mostFiles)
        files.push_back(refused(
            folder, Text::tr("This folder has %L1 lessons; only the first %2 by name are read.")
                        .arg(names.size())
                        .arg(mostFiles)));
    return files;
}

} // namespace

QStringList LessonFile::sentences() const
{
    QStringList all;
    for (const LessonFault& fault : faults)
        all << path
                   + (fault.line > 0 ? QStringLiteral(":%1: ").arg(fault.line)
                                     : QStringLiteral(": "))
                   + fault.sentence;
    return all;
}

bool isLessonPath(const QString& path)
{
    return QFileInfo(path).isDir() || path.endsWith(u".md", Qt::CaseInsensitive);
}

std::vector<LessonFile> readLessonFiles(const QStringList& paths, const Follower& follower)
{
    std::vector<LessonFile> files;
    for (const QString& path : paths) {
        if (!QFileInfo(path).isDir())
            files.push_back({.path = path});
        else
            std::ranges::move(filesIn(path), std::back_inserter(files));
    }
    for (std::size_t i = 0; i < files.size() && !follower.stop.stop_requested(); ++i)
        if (files[i].faults.empty())
            files[i] = readLessonFile(files[i].path);
    return files;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/lessons/lesson_export.h"

#include "app/lessons/lesson_page.h"
#include "app/settings/remembered.h"
#include "ui/look/text.h"

#include <QFileInfo>
#include <QSettings>
#include <QStandardPaths>

namespace ui {

namespace {

const QString folderOfPages = QStringLiteral("lessonPagesFolder");

} // namespace

LessonExport::LessonExport(QWidget& window, const app::Course& course)
    : QObject(&window), course_(course), questions_(std::make_unique<Questions>(window)),
      background_(&window)
{
}

void LessonExport::ask()
{
    const app::Lesson* lesson = course_.lesson();
    if (!lesson)
        return;
    const QString folder = app::rememberedFolder(
        folderOfPages, QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    const QString path = questions_->fileToWrite(
        Text::tr("Export lesson as web page"),
        folder + u'/' + QFileInfo(lesson->key).completeBaseName() + QStringLiteral(".html"),
        Text::tr("Web page"), QStringLiteral("html"));
    if (path.isEmpty())
        return;
    QSettings().setValue(folderOfPages, QFileInfo(path).path());
    background_.run(
        Text::tr("Writing the lesson…"),
        [lesson = *lesson, path](const app::Follower&) {
            return app::writeLessonPage(lesson, path);
        },
        [this, path](const std::optional<std::optional<QString>>& error) {
            if (error && *error)
                emit told({Message::Kind::Warning, **error});
            else if (error)
                emit told({Message::Kind::Done, Text::tr("Wrote %1.").arg(path)});
        },
        InBackground::Cancel::Stops);
}

} // namespace ui

#include "moc_lesson_export.cpp"

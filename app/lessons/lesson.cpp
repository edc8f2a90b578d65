// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/lesson.h"

#include "app/base/text.h"
#include "app/lessons/parse_lesson.h"

#include <QFile>

#include <array>

namespace app {

namespace {

// THE CATALOGUE. To add a lesson: write its file in resources/lessons/, and add its key here.
// clang-format off
constexpr std::array keys{
    "why-clip",
    "outcodes",
    "parameters",
    "nicholl-lee-nicholl",
    "skala",
    "kwc",
    "method-2019",
    "fewest-operations",
    "rounding",
    "how-a-clipper-fails",
};
// clang-format on

} // namespace

Result<Lesson> readLesson(const QString& key, const QString& text)
{
    ParsedLesson parsed = parseLesson(key, text);
    if (parsed.faults.empty())
        return Result<Lesson>::of(std::move(parsed.lesson));
    const LessonFault& fault = parsed.faults.front();
    return Result<Lesson>::failure(
        Text::tr("line %1: %2 No lesson was read.").arg(fault.line).arg(fault.sentence));
}

const std::vector<Lesson>& lessons()
{
    static const std::vector<Lesson> all = [] {
        std::vector<Lesson> read;
        for (const char* key : keys) {
            const QString name = QString::fromLatin1(key);
            QFile file(QStringLiteral(":/lessons/%1.md").arg(name));
            if (file.open(QIODevice::ReadOnly))
                if (auto lesson = readLesson(name, QString::fromUtf8(file.readAll())))
                    read.push_back(*lesson.value);
        }
        return read;
    }();
    return all;
}

} // namespace app

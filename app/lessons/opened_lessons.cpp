// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/lessons/opened_lessons.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <deque>
#include <utility>

namespace app {

namespace {

constexpr qsizetype mostNotes = 20;

/// An opened lesson stays where it is, because a course may be in it.
struct OpenedLesson {
    QString path;
    Lesson lesson;
};

struct Opened {
    std::deque<OpenedLesson> lessons;
    std::vector<LessonGroup> groups;
    int openings = 0;
};

Opened& opened()
{
    static Opened all;
    return all;
}

LessonGroup& groupOf(const QString& folder)
{
    auto& groups = opened().groups;
    const auto found = std::ranges::find(groups, folder, &LessonGroup::folder);
    if (found != groups.end())
        return *found;
    const QString name = QDir(folder).dirName();
    return groups.emplace_back(LessonGroup{folder, name.isEmpty() ? folder : name, {}, {}});
}

const OpenedLesson& openedAt(std::size_t number)
{
    return opened().lessons[number - lessons().size()];
}

/// The group of an opened lesson, and its place there; null: the lesson was replaced.
std::pair<const LessonGroup*, std::size_t> placeIn(std::size_t number)
{
    for (const LessonGroup& group : openedLessons())
        if (const auto found = std::ranges::find(group.lessons, number);
            found != group.lessons.end())
            return {&group, std::size_t(found - group.lessons.begin())};
    return {nullptr, 0};
}

std::size_t add(LessonGroup& group, LessonFile file, const QString& path)
{
    const std::size_t number = lessons().size() + opened().lessons.size();
    opened().lessons.push_back({path, *std::move(file.lesson)});
    const auto same = std::ranges::find_if(
        group.lessons, [&](std::size_t other) { return openedAt(other).path == path; });
    if (same == group.lessons.end())
        group.lessons.push_back(number);
    else
        *same = number;
    return number;
}

} // namespace

const std::vector<LessonGroup>& openedLessons() { return opened().groups; }

bool isOpened(const QString& path)
{
    const auto& [lessons, groups, openings] = opened();
    return std::ranges::find(groups, path, &LessonGroup::folder) != groups.end()
           || std::ranges::find(lessons, path, &OpenedLesson::path) != lessons.end();
}

int lessonOpenings() { return opened().openings; }

std::optional<std::size_t> addOpenedLessons(std::vector<LessonFile> files)
{
    ++opened().openings;
    std::optional<std::size_t> first;
    QStringList told; // the folders whose notes are new
    for (LessonFile& file : files) {
        const QFileInfo info(file.path);
        const QString path = info.absoluteFilePath();
        LessonGroup& group = groupOf(info.isDir() ? path : info.absolutePath());
        if (!told.contains(group.folder)) {
            told << group.folder;
            group.notes.clear();
        }
        file.path = info.fileName();
        group.notes =
            (group.notes + file.sentences())
                .first(std::min(mostNotes, group.notes.size() + qsizetype(file.faults.size())));
        if (!file.lesson)
            continue;
        const std::size_t number = add(group, std::move(file), path);
        first = first.value_or(number);
    }
    return first;
}

void closeOpenedLessons(const QString& folder)
{
    auto& [lessons, groups, openings] = opened();
    const auto group = std::ranges::find(groups, folder, &LessonGroup::folder);
    if (group == groups.end())
        return;
    ++openings;
    for (const std::size_t number : group->lessons)
        lessons[number - app::lessons().size()].path.clear(); // no more opened
    groups.erase(group);
}

const Lesson* lessonAt(std::size_t number)
{
    const auto& own = lessons();
    if (number < own.size())
        return &own[number];
    return number - own.size() < opened().lessons.size() ? &openedAt(number).lesson : nullptr;
}

std::optional<std::size_t> lessonAfter(std::size_t number)
{
    if (number < lessons().size())
        return number + 1 < lessons().size() ? std::optional(number + 1) : std::nullopt;
    const auto [group, place] = placeIn(number);
    return group && place + 1 < group->lessons.size() ? std::optional(group->lessons[place + 1])
                                                      : std::nullopt;
}

std::size_t placeOfLesson(std::size_t number)
{
    return (number < lessons().size() ? number : placeIn(number).second) + 1;
}

} // namespace app

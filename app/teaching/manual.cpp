// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/manual.h"

#include "app/base/text.h"
#include "clipping/pseudo_code.h"

#include <QFile>
#include <QHash>
#include <QRegularExpression>

namespace app {

namespace {

const QString folder = QStringLiteral(":/manual/"), ending = QStringLiteral(".md");

// "[Snapping](snapping.md)"
const QRegularExpression& pageLinks()
{
    static const QRegularExpression links(
        QStringLiteral("\\[([^\\]]+)\\]\\(([a-z-]+)\\.md(?:#[^)]*)?\\)"));
    return links;
}

} // namespace

QString withoutComments(QString markdown)
{
    static const QRegularExpression comment(QStringLiteral("<!--.*?-->"),
                                            QRegularExpression::DotMatchesEverythingOption);
    return markdown.remove(comment).trimmed();
}

std::optional<ManualPage> manualPage(const QString& topic)
{
    QFile file(folder + topic + ending);
    if (topic.contains(u'/') || !file.open(QIODevice::ReadOnly))
        return std::nullopt;
    QString markdown = QString::fromUtf8(file.readAll());
    static const QRegularExpression explains(QStringLiteral("<!-- explains:([^>]*)-->"));
    const QStringList commands =
        explains.match(markdown).captured(1).simplified().split(u' ', Qt::SkipEmptyParts);
    static const QRegularExpression shows(QStringLiteral("<!-- shows:(.*?)-->"),
                                          QRegularExpression::DotMatchesEverythingOption);
    const QString shown = shows.match(markdown).captured(1).trimmed();
    markdown = withoutComments(markdown);
    return ManualPage{topic, markdown.section(u'\n', 0, 0).mid(2), markdown, commands, shown};
}

std::vector<ManualPart> manualParts()
{
    const QString heading = QStringLiteral("## ");
    std::vector<ManualPart> parts;
    const auto index = manualPage(manualIndex);
    for (const QString& line : index ? index->markdown.split(u'\n') : QStringList())
        if (line.startsWith(heading))
            parts.push_back({line.mid(heading.size()), {}});
        else if (const auto link = pageLinks().match(line); link.hasMatch() && !parts.empty())
            parts.back().topics << link.captured(2);
    return parts;
}

QStringList manualTopics()
{
    QStringList topics{manualIndex};
    for (const ManualPart& part : manualParts())
        topics << part.topics;
    return topics;
}

QString topicExplaining(const QString& command)
{
    static const QHash<QString, QString> topics = [] {
        QHash<QString, QString> all;
        for (const QString& topic : manualTopics())
            if (const auto page = manualPage(topic))
                for (const QString& one : page->explains)
                    all[one] = topic;
        return all;
    }();
    return topics.value(command);
}

QString topicOfPage(const QString& link)
{
    const QString name = link.section(u'/', -1);
    const QString topic = name.endsWith(ending) ? name.chopped(ending.size()) : QString();
    return !topic.isEmpty() && QFile::exists(folder + name) ? topic : QString();
}

QString plainText(const ManualPage& page)
{
    static const QRegularExpression picture(QStringLiteral("!\\[[^\\]]*\\]\\([^)]*\\)\n*"));
    static const QRegularExpression emphasis(
        QStringLiteral("(?<![\\w*])(\\*{1,2})(?=\\S)([^*\n]+(?:\n[^*\n]+)?)(?<=\\S)\\1(?![\\w*])"));
    QString text = page.markdown;
    text.remove(picture);
    text.replace(pageLinks(), QStringLiteral("\\1 (\\2)"));
    text.replace(emphasis, QStringLiteral("\\2"));
    return text + u'\n';
}

namespace {

/// A form's pseudo-code as a page shows it: numbered, in a block.
QString blockOf(std::string_view code)
{
    QString block = QStringLiteral("```\n");
    int number = 0;
    for (const QString& line : shownCode(code))
        block += QStringLiteral("%1  %2\n").arg(++number, 2).arg(line);
    return block + QStringLiteral("```");
}

} // namespace

QString pageLink(const clipping::Algorithm& algorithm) { return latin(algorithm.key) + ending; }

QString pageOf(const clipping::Algorithm& algorithm)
{
    QFile file(QStringLiteral(":/algorithms/%1.md").arg(latin(algorithm.key)));
    if (!file.open(QIODevice::ReadOnly))
        return QStringLiteral("# %1 (%2)\n\n%3")
            .arg(latin(algorithm.name))
            .arg(algorithm.year)
            .arg(latin(algorithm.idea));
    QString markdown = QString::fromUtf8(file.readAll());
    markdown.replace(QStringLiteral("{published code}"), blockOf(algorithm.publishedCode));
    markdown.replace(QStringLiteral("{corrected code}"), blockOf(algorithm.correctedCode));
    return markdown;
}

QStringList shownCode(std::string_view code)
{
    QStringList lines;
    for (const clipping::CodeLine& line : clipping::linesOf(code))
        lines << latin(line.text);
    return lines;
}

QStringList codeOf(const Variant& variant)
{
    return shownCode(clipping::codeOf(rowOf(variant), variant.form));
}

} // namespace app

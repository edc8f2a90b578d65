// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/command_line/parsed_arguments.h"

#include "app/base/number.h"
#include "app/base/text.h"
#include "app/command_line/command.h"
#include "app/command_line/given_value.h"
#include "app/command_line/nearest.h"

#include <QRegularExpression>

#include <algorithm>
#include <array>
#include <cmath>

namespace app {
namespace {

std::vector<Option> optionsOf(const Command& command)
{
    auto options = command.options;
    options.push_back({{"h", "help"}, {}, Text::tr("Show this help.")});
    return options;
}

std::string trimmed(const QString& text) { return text.trimmed().toStdString(); }

QString dashed(const QString& name)
{
    return (name.size() > 1 ? QStringLiteral("--") : QStringLiteral("-")) + name;
}

/// Why the parser rejects the arguments.
QString refusalOf(const QCommandLineParser& parser, const Command& command)
{
    const QStringList unknown = parser.unknownOptionNames();
    if (unknown.isEmpty())
        return parser.errorText().replace(QRegularExpression(QStringLiteral("'([^']*)'")),
                                          QStringLiteral("“\\1”"));
    QStringList names;
    for (const Option& option : optionsOf(command))
        names << option.names.last();
    const QString nothing = Text::tr("There is no option “%1”.").arg(dashed(unknown.front()));
    const auto nearest = nearestTo(unknown.front().toLower(), names);
    return nearest ? nothing + u' ' + Text::tr("Did you mean “%1”?").arg(dashed(*nearest))
                   : nothing;
}

std::optional<quint64> wholeNumber(const QString& text)
{
    bool isNumber = false;
    if (const quint64 number = text.toULongLong(&isNumber); isNumber)
        return number;
    constexpr double most = 9007199254740992;       // 2^53: all integers up to it are exact
    const auto number = parseNumber(trimmed(text)); // 1e6
    if (!number || *number < 0 || *number > most || *number != std::floor(*number))
        return std::nullopt;
    return quint64(*number);
}

} // namespace

ParsedArguments::ParsedArguments(const Command& command, const QStringList& arguments)
{
    for (const Option& option : optionsOf(command)) {
        QCommandLineOption row(option.names);
        row.setValueName(option.value);
        for (const QString& name : option.names)
            longNames_[name] = option.names.last();
        parser_.addOption(row);
    }
    if (!parser_.parse(QStringList(QString()) + arguments))
        throw WrongUsage{refusalOf(parser_, command)};
    if (helpWanted())
        return;
    if (operands().size() < command.operands - (command.lastIsOptional ? 1 : 0))
        throw WrongUsage{Text::tr("An argument is missing: %1 %2.")
                             .arg(QLatin1StringView(command.key), command.usage)};
    if (operands().size() > command.operands && !command.lastRepeats)
        throw WrongUsage{
            Text::tr("The argument “%1” is one too many.").arg(operands()[command.operands])};
}

std::optional<QString> ParsedArguments::text(const QString& option) const
{
    return has(option) ? std::optional(parser_.value(option)) : std::nullopt;
}

void ParsedArguments::refuse(const QString& option, const QString& expected) const
{
    app::refuse({option, parser_.value(option)}, expected);
}

std::vector<GivenValue> ParsedArguments::inOrder(const QStringList& options) const
{
    std::vector<GivenValue> given;
    std::map<QString, qsizetype> seen;
    for (const QString& name : parser_.optionNames())
        if (const QString& option = longNames_.at(name); options.contains(option))
            given.push_back({option, parser_.values(option).value(seen[option]++)});
    return given;
}

std::optional<quint64> ParsedArguments::count(const QString& option, quint64 least,
                                              quint64 most) const
{
    const auto value = text(option);
    if (!value)
        return std::nullopt;
    const auto number = wholeNumber(*value);
    if (!number || *number < least || *number > most)
        refuse(option, Text::tr("a whole number from %1 to %2").arg(least).arg(most));
    return number;
}

std::optional<double> ParsedArguments::positive(const QString& option) const
{
    const auto value = text(option);
    if (!value)
        return std::nullopt;
    const auto number = parseNumber(trimmed(*value));
    if (!number || *number <= 0)
        refuse(option, Text::tr("a number greater than 0"));
    return number;
}

std::optional<Length> ParsedArguments::length(const QString& option) const
{
    const auto value = text(option);
    if (!value)
        return std::nullopt;
    const auto length = parseLength(value->toStdString());
    if (!length || length->unit == Unit::Percent)
        refuse(option, Text::tr("a length such as 0.5 or 10mm"));
    return length;
}

std::optional<std::array<Length, 4>> ParsedArguments::rectangle(const QString& option) const
{
    const auto value = text(option);
    if (!value)
        return std::nullopt;
    const QString expected = Text::tr("four lengths XMIN,YMIN,XMAX,YMAX such as "
                                      "-100,-75,100,75 or 0,0,10cm,70mm");
    const auto given = lengthsOf({option, *value}, *value, expected);
    if (given.size() != 4)
        app::refuse({option, *value}, expected);
    std::array<Length, 4> lengths;
    std::ranges::copy(given, lengths.begin());
    return lengths;
}

std::vector<const clipping::Algorithm*> ParsedArguments::algorithms(const QString& option) const
{
    std::vector<const clipping::Algorithm*> found;
    const auto value = text(option);
    if (!value)
        return found;
    const QStringList names = value->split(u',');
    for (const QString& name : names) {
        if (name == QLatin1String("all"))
            for (const auto& algorithm : clipping::algorithms())
                found.push_back(&algorithm);
        else if (const auto* algorithm = clipping::findAlgorithm(trimmed(name)))
            found.push_back(algorithm);
        else
            throw WrongUsage{Text::tr("There is no algorithm “%1”. “clearcut algorithms” lists "
                                      "them all.")
                                 .arg(name)};
    }
    return found;
}

std::optional<Variant> ParsedArguments::variant(const QString& option) const
{
    const auto key = text(option);
    if (!key)
        return std::nullopt;
    if (auto variant = findVariant(*key))
        return variant;
    QStringList more;
    for (const Misprint& misprint : misprints())
        more << misprint.key;
    throw WrongUsage{
        Text::tr("There is no algorithm “%1”. Give a key or abbreviation from the list of "
                 "“clearcut algorithms”, with :published for the published form, or %2.")
            .arg(*key, more.join(Text::tr(", ")))};
}

std::optional<std::array<double, 4>> ParsedArguments::numbers(const QString& option,
                                                              const QString& names) const
{
    const auto value = text(option);
    if (!value)
        return std::nullopt;
    return fourNumbers({option, *value}, *value, names);
}

const Format* ParsedArguments::format(const QString& option) const
{
    const auto value = text(option);
    if (!value)
        return nullptr;
    if (const Format* format = findFormat(*value))
        return format;
    QStringList keys;
    for (const Format& format : formats())
        keys << QLatin1StringView(format.key);
    refuse(option, keys.join(QStringLiteral(", ")));
}

std::size_t ParsedArguments::choice(const QString& option, const QStringList& words) const
{
    const auto value = text(option);
    if (!value)
        return 0;
    const auto index = words.indexOf(value->toLower());
    if (index < 0)
        refuse(option, words.join(Text::tr(" or ")));
    return std::size_t(index);
}

QString wrapped(const QString& text, qsizetype indent, qsizetype width)
{
    QString result;
    qsizetype column = indent;
    const QStringList words = text.split(u' ');
    for (const QString& word : words) {
        if (column > indent && column + 1 + word.size() > width) {
            result += u'\n' + QString(indent, u' ');
            column = indent;
        }
        const QString piece = column > indent ? u' ' + word : word;
        result += piece;
        column += piece.size();
    }
    return result + u'\n';
}

namespace {

/// The start of the second column: after the first one, but not to the right of `most`.
qsizetype secondColumn(const std::vector<std::pair<QString, QString>>& rows, qsizetype most)
{
    qsizetype column = 0;
    for (const auto& row : rows)
        if (row.first.size() + 4 <= most)
            column = std::max(column, row.first.size() + 4);
    return column > 0 ? column : most;
}

// A command line, wrapped where a shell continues reading.
QString brokenExample(const QString& example)
{
    constexpr qsizetype indent = 6;
    const QStringList lines =
        wrapped(example, indent, helpWidth - 2).split(u'\n', Qt::SkipEmptyParts);
    return QStringLiteral("  ") + lines.join(QStringLiteral(" \\\n")) + u'\n';
}

QString listed(const QString& heading, const QStringList& sentences)
{
    QString text = u'\n' + heading + u'\n';
    for (const QString& sentence : sentences)
        text += QStringLiteral("  ") + wrapped(sentence, 2);
    return sentences.isEmpty() ? QString() : text;
}

/// An option with a list of choices that is too long for a line, broken after a "|".
QString brokenChoices(const QString& option)
{
    constexpr qsizetype indent = 8;
    QString text, line = option;
    while (line.size() > helpWidth) {
        const qsizetype end = line.lastIndexOf(u'|', helpWidth - 1) + 1;
        if (end <= indent)
            break; // a single long word
        text += line.first(end) + u'\n';
        line = QString(indent, u' ') + line.sliced(end);
    }
    return text + line;
}

} // namespace

QString aligned(const std::vector<std::pair<QString, QString>>& rows)
{
    const qsizetype indent = secondColumn(rows, helpWidth / 2);
    QString text;
    for (const auto& [left, right] : rows) {
        const QString first = QStringLiteral("  ") + left;
        text += first.size() + 2 <= indent ? first.leftJustified(indent)
                                           : brokenChoices(first) + u'\n' + QString(indent, u' ');
        text += wrapped(right, indent);
    }
    return text;
}

QString inColumns(const std::vector<std::pair<QString, QString>>& rows)
{
    qsizetype indent = 0;
    for (const auto& row : rows)
        indent = std::max(indent, row.first.size() + 4);
    QString text;
    for (const auto& [left, right] : rows)
        text += (QStringLiteral("  ") + left).leftJustified(indent) + right + u'\n';
    return text;
}

QString helpOf(const Command& command)
{
    QString text =
        Text::tr("Usage: clearcut %1 %2\n\n%3\nOptions:\n")
            .arg(QLatin1StringView(command.key), command.usage, wrapped(command.summary, 0));
    std::vector<std::pair<QString, QString>> rows;
    for (const Option& option : optionsOf(command)) {
        QString names = option.names.size() > 1 ? QString() : QStringLiteral("    ");
        for (const QString& name : option.names)
            names += (names.trimmed().isEmpty() ? QString() : QStringLiteral(", "))
                     + (name.size() > 1 ? QStringLiteral("--") : QStringLiteral("-")) + name;
        rows.emplace_back(option.value.isEmpty() ? names : names + u' ' + option.value,
                          option.meaning);
    }
    text += aligned(rows) + listed(Text::tr("Limits:"), command.limits);
    if (!command.examples.isEmpty())
        text += u'\n' + Text::tr("Examples:") + u'\n';
    for (const QString& example : command.examples)
        text += brokenExample(example);
    return text;
}

} // namespace app

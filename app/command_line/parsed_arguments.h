// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/command.h"
#include "app/command_line/given_value.h"
#include "app/comparison/variants.h"
#include "app/formats/format.h"

#include <QCommandLineParser>

#include <array>
#include <map>
#include <optional>

namespace app {

/// The parsed arguments of a command, by its table of options. Each accessor throws WrongUsage if
/// the argument is not valid.
class ParsedArguments {
public:
    /// `arguments` without the command's key.
    ParsedArguments(const Command& command, const QStringList& arguments);

    bool helpWanted() const { return has(QStringLiteral("help")); }
    bool has(const QString& option) const { return parser_.isSet(option); }
    bool knows(const QString& option) const { return longNames_.contains(option); } ///< the command
    QStringList operands() const { return parser_.positionalArguments(); }
    /// The value as written; empty if the option was not given.
    std::optional<QString> text(const QString& option) const;

    /// The values of these options in the order in which they were given, which may be several
    /// times; "" for an option without a value.
    std::vector<GivenValue> inOrder(const QStringList& options) const;

    /// A whole number from `least` to `most`.
    std::optional<quint64> count(const QString& option, quint64 least, quint64 most) const;
    std::optional<double> positive(const QString& option) const;
    std::optional<Length> length(const QString& option) const;
    /// XMIN,YMIN,XMAX,YMAX, each with an optional unit.
    std::optional<std::array<Length, 4>> rectangle(const QString& option) const;
    /// A comma-separated list of keys and abbreviations; `all` stands for every algorithm. Empty if
    /// not given.
    std::vector<const clipping::Algorithm*> algorithms(const QString& option) const;
    /// A key or abbreviation, with :published for a published form, or a known misprint.
    std::optional<Variant> variant(const QString& option) const;
    /// Four plain numbers; `names` is their name in the error message: "X1,Y1,X2,Y2".
    std::optional<std::array<double, 4>> numbers(const QString& option, const QString& names) const;
    const Format* format(const QString& option) const;
    /// The index of the value in `words`; 0 if it was not given.
    std::size_t choice(const QString& option, const QStringList& words) const;

private:
    [[noreturn]] void refuse(const QString& option, const QString& expected) const;

    QCommandLineParser parser_;
    std::map<QString, QString> longNames_; ///< of each option, by all its names
};

/// The output of `clearcut KEY --help`.
QString helpOf(const Command& command);

/// The width of help texts, in columns of a terminal.
constexpr qsizetype helpWidth = 80;

/// Wraps text into lines of at most `width` characters; lines after the first begin with `indent`
/// spaces, and the first line leaves room for as many.
QString wrapped(const QString& text, qsizetype indent, qsizetype width = helpWidth);

/// Lines of two columns, the second one aligned and wrapped. It has at least half of the width:
/// longer text in the first column gets a line of its own.
QString aligned(const std::vector<std::pair<QString, QString>>& rows);

/// The same for data, which is never wrapped.
QString inColumns(const std::vector<std::pair<QString, QString>>& rows);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/length.h"
#include "app/command_line/command.h"
#include "app/comparison/variants.h"
#include "app/formats/format.h"

#include <QCommandLineParser>

#include <array>
#include <optional>

namespace app {

/// The arguments of a command, taken apart by its table of options. Each question throws WrongUsage
/// if what was given does not fit.
class Given {
public:
    /// `arguments` without the command's key.
    Given(const Command& command, const QStringList& arguments);

    bool helpWanted() const { return has(QStringLiteral("help")); }
    bool has(const QString& option) const { return parser_.isSet(option); }
    QStringList operands() const { return parser_.positionalArguments(); }
    /// As it was written; nothing if it was not.
    std::optional<QString> text(const QString& option) const;

    /// A whole number from `least` to `most`.
    std::optional<quint64> count(const QString& option, quint64 least, quint64 most) const;
    std::optional<double> positive(const QString& option) const;
    std::optional<Length> length(const QString& option) const;
    /// XMIN,YMIN,XMAX,YMAX, each with a unit of its own if it likes.
    std::optional<std::array<Length, 4>> rectangle(const QString& option) const;
    /// A comma-separated list of keys and abbreviations; `all` is every one. Empty if not given.
    std::vector<const clipping::Algorithm*> algorithms(const QString& option) const;
    /// A key or abbreviation, with :published where there is such a form, or an exhibit.
    std::optional<Variant> variant(const QString& option) const;
    /// Four bare numbers; `names` is what the refusal calls them: "X1,Y1,X2,Y2".
    std::optional<std::array<double, 4>> numbers(const QString& option, const QString& names) const;
    const Format* format(const QString& option) const;
    /// Which of `words` it is; the first one if it was not given.
    std::size_t choice(const QString& option, const QStringList& words) const;

private:
    [[noreturn]] void refuse(const QString& option, const QString& expected) const;
    /// The same for numbers with commas between them, one of which may be too large.
    [[noreturn]] void refuseNumbers(const QString& option, const QString& expected) const;

    QCommandLineParser parser_;
};

/// What `clearcut KEY --help` prints.
QString helpOf(const Command& command);

/// Columns of a terminal, into which every help fits.
constexpr qsizetype helpWidth = 80;

/// Broken into lines of at most `width` characters; those after the first begin with `indent`
/// spaces, and the first one stands behind as many.
QString wrapped(const QString& text, qsizetype indent, qsizetype width = helpWidth);

/// Lines of two columns, the second one aligned and broken. It has half of the width at least: what
/// is too long for the first column stands in a line of its own.
QString aligned(const std::vector<std::pair<QString, QString>>& rows);

/// The same for data, which are never broken.
QString inColumns(const std::vector<std::pair<QString, QString>>& rows);

} // namespace app

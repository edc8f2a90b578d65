// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/command_line/given.h"

// Drawings in and out of commands: a file, or - for standard input and output. The type is that of
// --from and --to, or else of the name's ending.

namespace app {

/// The options of every command that reads, and of every command that writes a drawing.
std::vector<Option> readingOptions();
std::vector<Option> writingOptions();

/// --tolerance, of commands that flatten curves.
Option toleranceOption();
/// What it says, in user units; throws WrongUsage. Left to itself it is the usual one.
double toleranceOf(const Given& given, const Page& page);

/// Says on standard error that so many were not written, if any.
void sayHiddenLeftOut(std::size_t count, const Format& format);

/// How much a file may hold that is read, or that is read or written, a sentence for each type.
QStringList readingLimits();
QStringList readingAndWritingLimits();

/// Reads `path`; throws Failure.
Imported readDrawing(const Given& given, const QString& path);

/// Where a drawing will go: known before anything is read, so that a wrong usage is said at once.
struct Output {
    QString path; ///< "-": standard output
    const Format* format;
    WriteOptions options;
};

/// What --output, --to, --in-place, --precision and --dpi say; throws WrongUsage, also if it would
/// write over `input` without --in-place.
Output outputOf(const Given& given, const QString& input);

/// Throws Failure; what is there is lost only to a whole new file.
void writeDrawing(const Document& document, const Output& output);

/// Throws Failure if that would lose what the import could not keep: writing over the input.
void refuseLossInPlace(const Given& given, const Imported& imported, const QString& input,
                       const Output& output);

/// Says on standard error what `losses` lists.
void sayLosses(const Imported& imported);

/// What an import could not keep, a line for each kind, with how often: "3 × text".
QStringList losses(const Imported& imported);

} // namespace app

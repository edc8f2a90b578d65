// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/base/replace_file.h"
#include "app/command_line/parsed_arguments.h"

// Input and output of drawings: a file, or - for standard input and output. The type is given by
// --from and --to, otherwise by the name's ending.

namespace app {

/// The options of every command that reads, or writes, a drawing.
std::vector<Option> readingOptions();
std::vector<Option> writingOptions();

/// --tolerance, for commands that flatten curves.
Option toleranceOption();
/// The value of --tolerance in user units, or the default; throws WrongUsage.
double toleranceOf(const ParsedArguments& arguments, const Page& page);

/// Reports on standard error how many hidden objects were not written, if any.
void sayHiddenLeftOut(std::size_t count, const Format& format);

/// The size limits of files that are read, or read and written, a sentence for each type.
QStringList readingLimits();
QStringList readingAndWritingLimits();

/// The type of a command's input, as --from or its name says; throws WrongUsage. For a file that is
/// not there it is that of its name, or any, because reading it says so.
const Format& readFormatOf(const ParsedArguments& arguments, const QString& path);

/// Reads the drawing in the file `path`, whose type its name shows; throws Failure.
Imported readDrawing(const QString& path);
/// The same for the input of a command, which may be standard input, or have a type that is given.
Imported readDrawing(const ParsedArguments& arguments, const QString& path);

/// --clip-paths, for commands that do not cut.
Option clipPathsOption();

/// --join, for commands that write a drawing.
Option joinOption();
/// Joins lines whose ends meet, if --join is given; throws WrongUsage.
void joinAsAsked(const ParsedArguments& arguments, Imported& imported);

/// The target of a drawing, known before anything is read, so that a wrong usage is reported first.
struct Output {
    QString path; ///< "-": standard output
    const Format* format;
    WriteOptions options;
};

/// The parsed --output, --to, --in-place, --precision and --dpi; throws WrongUsage, also if the
/// target is `input` without --in-place.
Output outputOf(const ParsedArguments& arguments, const QString& input);

/// Reports how many lines --precision would make points, if any; they are left out.
void sayPoints(std::size_t count);

/// Tells the output of the page of the drawing that was read.
void takePage(Output& output, const Imported& imported);

/// Reports what an outline drawing (DXF) does not hold of these objects.
void sayNotHeld(const Document& document, const ObjectRanges& objects, const Output& output);
/// Reports positions of a written map outside of its projection.
void sayOutsideMap(const Document& written, const Output& output);

/// Replaces an existing file only by a complete new one; throws Failure.
void writeDrawing(const Document& document, const Output& output);

/// The same for output that is made bit by bit, to a file or -: standard output passes on each
/// write at once.
void writeWith(const Filling& write, const QString& path);

/// Throws Failure if overwriting the input would lose what the import could not keep.
void refuseLossInPlace(const ParsedArguments& arguments, const Imported& imported,
                       const QString& input, const Output& output);

/// Reports the `losses` on standard error.
void sayLosses(const std::vector<Loss>& report);

/// What an import could not keep, a line for each kind, with its number: "3 × text".
QStringList losses(const std::vector<Loss>& report);

} // namespace app

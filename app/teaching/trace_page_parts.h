// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/teaching/step_scene.h"
#include "app/teaching/trace_file.h"

#include <QByteArray>
#include <QSizeF>

// The parts of a trace's web page, in UTF-8. Every text in them is escaped.

namespace app {

/// A paragraph of a class; empty for an empty text.
QByteArray paragraphHtml(const char* className, const QString& text);
/// The variables after a step, as a table.
QByteArray variablesHtml(const NarratedStep& narrated);
/// The operations up to a step, and of the whole narration, as a table.
QByteArray operationsHtml(const Narration& narration, std::size_t step);
/// The start of a page that needs no network and no other file, up to its body. `more` is style
/// beyond that of all such pages: resources/trace_page/page.css and the colours of figures.
QByteArray pageHeadHtml(const QString& title, const QByteArray& more = {});
/// The title, the line and the window.
QByteArray headerHtml(const TraceExport& trace);
/// The buttons and the slider, hidden until the script runs, and what a screen reader hears.
QByteArray stepsBarHtml();
/// The pseudo-code; line n is element n of the list.
QByteArray codeHtml(const QStringList& code);
/// A step: figure number `figure`, sentence, line of the pseudo-code, variables, operations.
QByteArray stepHtml(const TraceStep& at, const QSizeF& figureSize, std::size_t figure);
/// What is needed to run the pseudo-code for another line; empty for a trace that is only one step,
/// and at convex windows.
QByteArray dataHtml(const TraceExport& trace, const QSizeF& figureSize);
/// That steps are not on the page; the arguments are the first and the last of them.
QString leftOutText(std::size_t from, std::size_t to);

} // namespace app

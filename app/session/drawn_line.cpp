// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/drawn_line.h"

#include "app/session/first_traced_line.h"
#include "app/session/inspection.h"
#include "app/session/window_in_hand.h"

#include <QScopedValueRollback>

namespace app {

namespace {

/// Only the line may differ: everything else is as this class set it.
bool sameButLine(TracedLine one, const TracedLine& other)
{
    one.line = other.line;
    return one == other;
}

} // namespace

DrawnLine::DrawnLine(Session& session, QObject* parent) : QObject(parent), session_(session)
{
    connect(&session.microscope, &Microscope::tracedLineChanged, this, &DrawnLine::notice);
    connect(&session.microscope, &Microscope::openChanged, this, &DrawnLine::adopt);
    connect(&session, &Session::displayChanged, this, &DrawnLine::followDisplay);
    connect(&session, &Session::previewChanged, this, &DrawnLine::followDrawing);
    connect(&session.scene, &Scene::outdated, this, &DrawnLine::followDrawing);
    connect(&session, &Session::inspectedChanged, this, &DrawnLine::followInspected);
}

void DrawnLine::look()
{
    if (const auto line = firstLine(session_)) {
        const bool ownChoice = !session_.inspected();
        look(*line);
        if (ownChoice)
            lent_ = line;
        return;
    }
    line_.reset();
    own_ = false;
    display_ = session_.variant();
    show(firstTracedLine(session_));
}

void DrawnLine::look(std::size_t segment) { show(segment, explaining(session_, segment)); }

void DrawnLine::show(std::size_t segment, const Variant& variant)
{
    lent_.reset();
    line_ = segment;
    own_ = false;
    display_ = session_.variant();
    TracedLine tracedLine = tracedLineOf(session_, segment);
    tracedLine.variant = variant;
    show(tracedLine);
    session_.inspect(segment);
}

void DrawnLine::go(std::ptrdiff_t lines)
{
    const auto count = std::ptrdiff_t(session_.scene.lines().size());
    if (count == 0)
        return;
    const auto now = line_ ? std::ptrdiff_t(*line_) : lines > 0 ? -1 : count;
    show(std::size_t(((now + lines) % count + count) % count),
         session_.microscope.tracedLine().variant);
}

void DrawnLine::choose(const Variant& variant)
{
    TracedLine tracedLine = session_.microscope.tracedLine();
    tracedLine.variant = variant;
    if (!attached_)
        return session_.microscope.setTracedLine(tracedLine);
    show(tracedLine);
    if (variant.misprint)
        return; // nothing is cut with it
    session_.changeDisplay([&variant](Display& display) {
        display.variant = {variant.algorithm, variant.form};
    });
}

void DrawnLine::back()
{
    const auto line = drawn();
    if (!line)
        return;
    own_ = false;
    TracedLine tracedLine = tracedLineOf(session_, *line_);
    tracedLine.variant = session_.microscope.tracedLine().variant;
    show(tracedLine);
}

bool DrawnLine::changed() const { return attached_ && own_ && line_; }

std::optional<clipping::Segment> DrawnLine::drawn() const
{
    const SceneLines& lines = session_.scene.lines();
    return line_ && *line_ < lines.size()
               ? std::optional(tracedWindow(session_).into(lines[*line_]))
               : std::nullopt;
}

void DrawnLine::show(const TracedLine& tracedLine)
{
    const QScopedValueRollback quiet(showing_, true);
    ours_ = tracedLine;
    attached_ = true;
    if (session_.microscope.isOpen())
        session_.microscope.setTracedLine(tracedLine);
    else
        session_.microscope.open(tracedLine);
    emit refreshed();
}

void DrawnLine::adopt()
{
    if (const auto lent = std::exchange(lent_, std::nullopt);
        lent && !session_.microscope.isOpen() && session_.inspected() == lent)
        return session_.inspect(std::nullopt);
    const auto inspected = session_.inspected();
    if (showing_ || !session_.microscope.isOpen() || !inspected)
        return;
    const TracedLine& now = session_.microscope.tracedLine();
    TracedLine inspectedOne = tracedLineOf(session_, *inspected);
    inspectedOne.variant = now.variant;
    if (now == inspectedOne)
        show(*inspected, now.variant);
}

/// The microscope got another traced line: the person chose one, or a lesson shows its own.
void DrawnLine::notice()
{
    if (showing_)
        return;
    const TracedLine& now = session_.microscope.tracedLine();
    attached_ = attached_ && sameButLine(now, ours_);
    own_ = attached_ && now.line != drawn();
    emit refreshed();
}

void DrawnLine::followDisplay()
{
    const Variant now = session_.variant();
    if (now == std::exchange(display_, now) || !attached_ || !session_.microscope.isOpen())
        return;
    TracedLine tracedLine = session_.microscope.tracedLine();
    tracedLine.variant = now;
    show(tracedLine);
}

void DrawnLine::followDrawing()
{
    if (!attached_ || !session_.microscope.isOpen())
        return;
    TracedLine tracedLine = session_.microscope.tracedLine();
    tracedWindow(session_).putInto(tracedLine);
    if (const auto line = drawn()) {
        const TracedLine drawnOne = tracedLineOf(session_, *line_);
        tracedLine.origin = drawnOne.origin;
        tracedLine.unit = drawnOne.unit;
        if (!own_)
            tracedLine.line = *line;
    } else {
        line_.reset();
    }
    show(tracedLine);
}

void DrawnLine::followInspected()
{
    const auto inspected = session_.inspected();
    if (showing_ || !attached_ || !session_.microscope.isOpen() || !inspected || inspected == line_)
        return;
    show(*inspected, session_.microscope.tracedLine().variant);
}

} // namespace app

#include "moc_drawn_line.cpp"

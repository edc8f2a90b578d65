// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/session/arrange_selection.h"
#include "ui/canvas/controller.h"

// Typed numbers, which make a gesture exact.

namespace ui {
namespace {

/// The text with which typing begins; empty: the key types no number.
QString firstTyped(const QKeyEvent& event, bool points)
{
    // Shift+2 and Shift+3 fit the view, unless a point can begin here.
    const QString first =
        points ? QStringLiteral("0123456789.,-+<@#(") : QStringLiteral("0123456789.,-+<(");
    const auto others =
        ~Qt::KeyboardModifiers(Qt::ShiftModifier | Qt::KeypadModifier | Qt::GroupSwitchModifier);
    if (event.text().size() != 1 || (event.modifiers() & others))
        return {};
    return first.contains(event.text().front()) ? event.text() : QString();
}

} // namespace

/// Of the gesture, of the finished step, or of the first point of the next gesture.
bool Controller::takesNumbers() const
{
    return readout_ && mayDraw()
           && tool_->as<TypesNumbers>().gauge(bench_); // the last step may be undone by now
}

app::DigitPlace Controller::digitPlace() const
{
    return {.gesture = gestureGoes(),
            .numbers = takesNumbers(),
            .draws = session_.worksInDraw,
            .windowChosen = toolInfo_->showsHandles() && session_.windowChosen()};
}

bool Controller::digitsChoose() const
{
    app::DigitPlace place = digitPlace();
    place.gesture = false;
    return app::digitUse(place) == app::DigitUse::Algorithm;
}

/// Enter opens the numbers of what was just done, also where digits have another use.
bool Controller::beginsTyping(const QKeyEvent& event) const
{
    if (!takesNumbers())
        return false;
    const bool enter = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
    const bool opens = gestureGoes() ? tool_->busy() && event.key() == Qt::Key_Tab : enter;
    if (opens && !(event.modifiers() & ~Qt::KeypadModifier))
        return true;
    const auto points = readout_->gauge().measure->points;
    const bool point = tool_->busy() || points == app::GestureMeasure::Points::Absolute;
    const QString first = firstTyped(event, point);
    // A sign says what the chosen clip window does, where digits choose its algorithm.
    const bool sign = first == QLatin1String("+") || first == QLatin1String("-");
    const bool forWindow = sign && actsOnWindow() && !gestureGoes();
    return !first.isEmpty() && !forWindow
           && (!first.front().isDigit() || digitUse() == app::DigitUse::Number);
}

/// A number typed during a gesture that takes none does nothing: it must not choose the algorithm.
bool Controller::keepsFromShortcuts(const QKeyEvent& event) const
{
    return gestureGoes() && !firstTyped(event, false).isEmpty();
}

/// Numbers that follow a finished step change it, until the next action.
void Controller::beginTyping(const QKeyEvent& event)
{
    const bool firstPoint = toolInfo_->draws() && (event.text() == "#" || event.text() == "@");
    if (!tool_->busy() && !firstPoint)
        withTool([&] { tool_->as<TypesNumbers>().reopen(bench_); });
    typing_ = true;
    if (event.key() == Qt::Key_Tab)
        readout_->activate(readout_->gauge().measure->fields.size() > 1 ? 1 : 0);
    typeNumber(firstTyped(event, true));
    emit typingBegan();
}

void Controller::typeNumber(const QString& text)
{
    if (!readout_)
        return;
    readout_->type(text);
    if (tool_->as<TypesNumbers>().corrects() && tool_->as<TypesNumbers>().pointBegins()
        && readout_->typesPoint())
        typeFirstPoint(text);
    steer();
}

/// What was typed so far for a correction is the beginning of a point for the next gesture.
void Controller::typeFirstPoint(const QString& text)
{
    withTool([&] { tool_->cancel(bench_); });
    if (!readout_)
        return;
    typing_ = true;
    readout_->type(text);
    emit typingBegan();
}

void Controller::lockNumber()
{
    if (readout_)
        readout_->lock();
    steer();
}

void Controller::releaseNumber()
{
    if (readout_)
        readout_->release();
    stopTyping();
}

void Controller::acceptNumber()
{
    if (!readout_)
        return;
    if (tool_->busy() && !tool_->as<TypesNumbers>().corrects() && readout_->typesDirection())
        return lockNumber(); // the length is still missing
    if (!readout_->accept(aim())) {
        emit readoutChanged();
        return;
    }
    const app::GestureEnd end = readout_->result(aim());
    if (toolInfo_->draws()
        && readout_->gauge().measure->points != app::GestureMeasure::Points::Refused)
        bench_.lastPoint = end.point;
    typing_ = false;
    readout_.reset();
    withTool([&] { tool_->as<TypesNumbers>().accept(end, bench_); });
    steer();
}

void Controller::transform(const app::Transformation& kind)
{
    endGesture();
    if (session_.selection().empty())
        session_.select(app::justAdded(session_));
    if (session_.selection().empty()) {
        emit session_.refused(kind.needs);
        return;
    }
    if (toolInfo_->key != "select")
        setTool("select");
    const app::Point middle = view().toDrawing(view().size * 0.5);
    const Pointer pointer =
        pointer_.value_or(Pointer{middle, middle, view().toScreen(middle), {}, {}, middle});
    withTool([&] { tool_->as<Transforms>().transform(kind, pointer, bench_); });
    steer();
}

void Controller::typeText(const app::TextRecipe& text)
{
    withTool([&] { tool_->as<TypesText>().typeText(text, bench_); });
}

void Controller::finishText()
{
    withTool([&] { tool_->as<TypesText>().finishText(bench_); });
}

void Controller::stopTyping()
{
    typing_ = false;
    if (tool_->as<TypesNumbers>().corrects()) // a correction ends with its field
        withTool([&] { tool_->cancel(bench_); });
    if (readout_ && !tool_->busy())
        readout_->releaseTyped(); // nothing is shown that it could hold
    steer();
}

bool Controller::showsReadout() const
{
    return readout_ && (typing_ || tool_->busy() || readout_->isLocked());
}

/// Gives the numbers of a gesture that has not begun back to the pointer.
bool Controller::releaseLocked()
{
    if (!readout_ || tool_->busy() || !readout_->isLocked())
        return false;
    readout_.reset();
    followGauge();
    emit changed();
    return true;
}

app::Point Controller::aim() const
{
    return pointer_ ? pointer_->steered : readout_ ? readout_->gauge().start.from : app::Point(0);
}

/// Holds the pointer at what is typed.
void Controller::steer(Pointer& pointer) const
{
    if (!readout_ || (!tool_->busy() && !readout_->holds()))
        return;
    const app::GestureEnd end = readout_->result(pointer.steered);
    pointer.position = end.point;
    pointer.numbers = end.numbers;
    pointer.held = readout_->holds();
}

/// Lets the tool follow what is typed, as if the pointer had moved.
void Controller::steer()
{
    if (readout_ && pointer_) {
        steer(*pointer_);
        withTool([&] { tool_->move(*pointer_, bench_); });
    }
    emit readoutChanged();
    emit changed();
}

/// What was typed ends with the gesture, or the step of it, for which it was typed.
void Controller::followGauge()
{
    const auto gauge = tool_->as<TypesNumbers>().gauge(bench_);
    if (gauge && readout_ && readout_->follow(*gauge))
        return;
    if (!gauge && !readout_)
        return;
    typing_ = false;
    readout_.reset();
    if (gauge)
        readout_.emplace(*gauge);
    emit readoutChanged();
}

} // namespace ui

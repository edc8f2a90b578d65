// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

namespace app {

/// The line of the drawing that the session's microscope shows. While it is shown, the microscope
/// follows the drawing: its window, its algorithm, the line itself and which line is inspected;
/// also if another part of the program opened the microscope at the inspected line. A change by the
/// person in the microscope (a moved end, another line typed in) stays until `back()`. A traced
/// line from elsewhere, such as a lesson's, is never changed.
class DrawnLine : public QObject {
    Q_OBJECT

public:
    explicit DrawnLine(Session& session, QObject* parent = nullptr);

    /// Opens the microscope at the inspected line, otherwise the longest line that the window cuts,
    /// otherwise any line; for an empty drawing, at a built-in example.
    void look();
    /// Opens it at this line, with the variant that explains it (app/session/inspection.h).
    void look(std::size_t segment);

    /// Goes to the next or previous lines, cyclically.
    void go(std::ptrdiff_t lines);
    /// Chooses another algorithm or form; if the microscope shows the drawing's line, also for the
    /// drawing, except a known misprint.
    void choose(const Variant& variant);
    /// Restores the line as it is in the drawing.
    void back();

    /// The line's number; empty: it is not a line of the drawing.
    std::optional<std::size_t> line() const { return attached_ ? line_ : std::nullopt; }
    /// Whether the line in the microscope differs from the drawing's.
    bool changed() const;

signals:
    void refreshed(); ///< `line` or `changed` may have changed

private:
    std::optional<clipping::Segment> drawn() const;
    void show(std::size_t segment, const Variant& variant);
    void show(const TracedLine& tracedLine);
    void adopt();
    void notice();
    void followDisplay();
    void followDrawing();
    void followInspected();

    Session& session_;
    std::optional<std::size_t> line_; ///< empty: the drawing is empty
    std::optional<std::size_t> lent_; ///< inspected only for the microscope: reset when that closes
    TracedLine ours_;                 ///< as this class showed it last
    Variant display_;                 ///< of the drawing, as last seen
    bool attached_ = false;           ///< this class controls the microscope's traced line
    bool own_ = false;                ///< the person changed the line
    bool showing_ = false;
};

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/session/session.h"

namespace app {

/// The line of the drawing that is under the session's microscope. As long as one looks at it, the
/// microscope follows the drawing: its window, its algorithm, the line itself and which line is
/// inspected; also when others opened the microscope at the inspected line. What the person changes
/// there (an end, another line typed in) stays until `back()`. Of a specimen from elsewhere, a
/// lesson's, it keeps its hands off.
class DrawnLine : public QObject {
    Q_OBJECT

public:
    explicit DrawnLine(Session& session, QObject* parent = nullptr);

    /// Opens the microscope: at the inspected line, else the first that the window cuts, else any;
    /// of an empty drawing at one of our own.
    void look();
    /// At this line, with what explains it (app/session/inspection.h).
    void look(std::size_t segment);

    /// The next line or the one before, round and round.
    void go(std::ptrdiff_t lines);
    /// With another algorithm or form: the drawing is clipped with it, too, if it is the drawing's.
    void choose(const Variant& variant);
    /// The drawing's line again, as it is there.
    void back();

    /// Which line; nothing: it is none of the drawing.
    std::optional<std::size_t> line() const { return attached_ ? line_ : std::nullopt; }
    /// Whether it is no longer where it is in the drawing.
    bool changed() const;

signals:
    void refreshed(); ///< `line` or `changed` may have changed

private:
    std::optional<clipping::Segment> drawn() const;
    void show(std::size_t segment, const Variant& variant);
    void show(const Specimen& specimen);
    void adopt();
    void notice();
    void followDisplay();
    void followDrawing();
    void followInspected();

    Session& session_;
    std::optional<std::size_t> line_; ///< nothing: of an empty drawing
    std::optional<std::size_t>
        lent_;              ///< inspected by us alone: no longer when the microscope closes
    Specimen ours_;         ///< as we showed it last
    Variant display_;       ///< of the drawing, as last seen
    bool attached_ = false; ///< what is under the microscope is ours
    bool own_ = false;      ///< the person changed the line
    bool showing_ = false;
};

} // namespace app

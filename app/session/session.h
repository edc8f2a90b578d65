// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/history.h"
#include "app/comparison/live_differences.h"
#include "app/document/object_ranges.h"
#include "app/exactness/live_truth.h"
#include "app/formats/format.h"
#include "app/lessons/course.h"
#include "app/scene/compared_window.h"
#include "app/scene/scene.h"
#include "app/session/preview.h"
#include "app/view/removed_part.h"

#include <optional>

namespace app {

/// How the drawing is being looked at: never part of the document, never undone.
struct Display {
    /// The algorithm, never null in a session, and the form that is wanted of each that has it.
    Variant variant{};
    RemovedPart removed = RemovedPart::Ghosted;
    Unit unit = Unit::Mm; ///< of rulers, labels and fields; a drawing that is opened brings its own
    bool overlay = false; ///< what the algorithm sees, over the drawing
    bool asPrinted = false;  ///< dark theme: the true page and inks
    bool presenting = false; ///< for a projector: strokes twice as wide, ghosts that can be seen
    friend bool operator==(const Display&, const Display&) = default;
};

/// How new objects are drawn, and where.
struct Pen {
    Style style{.stroke = Colour{}, .width = 1};
    ContainerId layer = 0; ///< one of the document; Session keeps it so
};

/// One open drawing with everything an editor window keeps about it, without a screen.
class Session : public QObject {
    Q_OBJECT

public:
    explicit Session(QObject* parent = nullptr);

    EditedDocument document;

private:
    // Connected before the scene is, which tells of the change to those who ask for the pen's layer
    // or the selection.
    QMetaObject::Connection following_ =
        connect(&document, &EditedDocument::changed, this, &Session::follow);

public:
    History history;
    Scene scene{document};
    LiveDifferences differences{document, scene}; ///< of two algorithms, while they are shown
    LiveTruth truth{document, scene}; ///< how exact an algorithm is, while that is shown
    Microscope microscope;            ///< one line, step by step
    Course course{microscope};        ///< a lesson, if one is being read
    Pen pen;

    const Document& now() const { return document.now(); }

    /// What is being dragged or drawn. Tools alone set it, and set an empty one when the gesture
    /// is over, after the command that it became.
    const Preview& preview() const { return preview_; }
    void setPreview(const Preview& preview);
    /// The clip window as it is now, the preview's if there is one; without any, the page. Here
    /// algorithms are compared, raced and explained.
    clipping::Window window() const { return compared().window; }
    ComparedWindow compared() const;
    /// The clip window as it is now, if there is one.
    std::optional<clipping::Window> clipWindow() const
    {
        return preview_.window ? preview_.window : firstWindow(now().windows());
    }
    /// All of them as they are now, the preview's too.
    const ClipWindows& windows() const { return windows_; }
    /// The same for `Scene::clip`.
    const ClipRegion& region() const { return region_; }

    const Display& display() const { return display_; }
    void setDisplay(const Display& display);
    /// What clips: the form that is wanted where the algorithm has it.
    Variant variant() const { return usable(display_.variant); }
    const clipping::Uses<clipping::Segment, clipping::Window>& uses() const;

    /// Numbers of objects; follows insertions and removals.
    const ObjectRanges& selection() const { return selection_; }
    void select(ObjectRanges objects);
    /// What the selection covers; nothing if that has no segments. Calculated when it is asked for,
    /// and kept until the selection or the document changes. Not for slots of
    /// EditedDocument::changed: there the scene may not have followed the document yet.
    const std::optional<clipping::Window>& selectionBounds() const;

    /// The line in the inspector: its number in scene.lines(); dropped when the scene changes.
    std::optional<std::size_t> inspected() const { return inspected_; }
    void inspect(std::optional<std::size_t> segment);

    /// Opens a drawing: clears history, selection, file name and losses first.
    void load(Imported imported, const QString& path = {});
    QString path() const { return path_; } ///< empty: never saved
    const std::vector<Loss>& losses() const { return losses_; }
    bool mustSaveAs() const; ///< no path, or the import lost something
    /// Saves to `path` (or where it came from) and remembers it; nothing, or the error.
    std::optional<QString> save(const QString& path);

signals:
    void displayChanged();
    void selectionChanged();
    void inspectedChanged();
    void previewChanged(); ///< preview() or windows(): by a gesture, a command, undo or load
    void fileChanged();
    void loaded(); ///< a different drawing: fit the view
    /// Something could not be done; the sentence says what, why, and what to do. Whoever has the
    /// session may emit it.
    void refused(const QString& sentence);

private:
    void updateWindows();
    void follow(const DocumentChange& change);
    void say(const DocumentChange& change);

    Display display_;
    ObjectRanges selection_;
    bool selectionFollowed_ = false; ///< it is another one, which was not said yet
    mutable std::optional<std::optional<clipping::Window>> selectionBounds_; ///< as far as known
    std::optional<std::size_t> inspected_;
    Preview preview_;
    ClipWindows windows_; ///< as they are now: each frame asks for them
    ClipRegion region_;
    QString path_;
    std::vector<Loss> losses_;
};

} // namespace app

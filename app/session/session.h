// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/commands/history.h"
#include "app/commands/transform_objects.h"
#include "app/comparison/live_differences.h"
#include "app/cut/permanent_cuts.h"
#include "app/document/object_ranges.h"
#include "app/document/window_frame.h"
#include "app/exactness/live_exactness.h"
#include "app/formats/format.h"
#include "app/practice/practice.h"
#include "app/scene/compared_window.h"
#include "app/scene/scene.h"
#include "app/session/entered_group.h"
#include "app/session/node_editing.h"
#include "app/session/pivot.h"
#include "app/session/preview.h"
#include "app/view/grid.h"
#include "app/view/picture_options.h"

#include <concepts>
#include <optional>

namespace app {

/// How the drawing is displayed: not part of the document, never undone.
struct Display {
    /// The algorithm (never null in a session) and the wanted form, used if the algorithm has it.
    Variant variant{};
    /// While the person compares: what cuts, whatever is shown. Empty: what is shown (comparing.h).
    std::optional<Variant> cuts{};
    RemovedPart removed = RemovedPart::Ghosted;
    Unit unit = Unit::Mm;    ///< of rulers, labels and fields; an opened drawing sets its own unit
    bool overlay = false;    ///< the algorithm's view of the plane, over the drawing
    bool darkPaper = false;  ///< the page is dark, and dark colours are shown lighter on it
    bool presenting = false; ///< for a projector: strokes twice as wide, clearly visible ghosts
    Grid grid{};             ///< under the drawing
    bool guides = true;      ///< are shown
    CutChoices cutting{};    ///< how the clip windows cut
    friend bool operator==(const Display&, const Display&) = default;
};

/// The style and the layer of new objects.
struct Pen {
    Style style{.stroke = Colour{}, .width = 1};
    ContainerId layer = 0; ///< Session ensures that it is one of the document's layers
};

/// How commands on the selection work: not part of the document.
struct ArrangeOptions {
    StrokeScaling strokes = StrokeScaling::Keep; ///< when objects are scaled
    std::string_view alignTo = "to-selection";   ///< key of what objects are aligned to
    double joinWithin = joiningMillimetres;      ///< ends of paths, in millimetres on paper
};

/// One open drawing with the whole state of an editor window, without a screen.
class Session : public QObject {
    Q_OBJECT

public:
    explicit Session(QObject* parent = nullptr);

    EditedDocument document;

private:
    // Connected before the scene, which passes the change on to listeners that need the pen's layer
    // or the selection.
    QMetaObject::Connection following_ =
        connect(&document, &EditedDocument::changed, this, &Session::follow);

public:
    History history;
    Scene scene{document};
    LiveDifferences differences{document, scene}; ///< of two variants, while shown
    LiveExactness exactness{document, scene};     ///< how exact an algorithm is, while shown
    Microscope microscope;                        ///< one line, step by step
    Course course{microscope};                    ///< the lesson in progress, if any
    Practice practice{microscope, course};        ///< the attempt to play an algorithm, if any
    NodeEditing nodes{*this};                     ///< of the selected objects
    EnteredGroup entered{*this};                  ///< the group that is being edited, if any
    Pivot pivot{*this};                           ///< of the selection
    Pen pen;
    /// The shape that the tool Clip window draws next (window_kinds.h); setNextWindow() changes it.
    std::string_view nextWindow = "rectangle";
    std::optional<std::size_t> guide{}; ///< the number of the chosen guide, which may be gone
    ArrangeOptions arrange;
    bool worksInDraw = false;    ///< whether the workspace is Draw
    bool worksInCompare = false; ///< whether it is one that compares

    const Document& now() const { return document.now(); }

    /// The change that the current gesture would make. Only tools set it; at the end of a gesture
    /// they push a command and set an empty preview.
    const Preview& preview() const { return preview_; }
    void setPreview(const Preview& preview);
    /// The rectangle at which algorithms are compared, raced and explained.
    clipping::Window window() const { return compared().window; }
    const ComparedWindow& compared() const { return compared_; }
    /// The same for what compares; empty: no clip window is such a rectangle, and at the page the
    /// results would not be those of the drawing.
    std::optional<clipping::Window> comparedAt() const { return compared_.place(); }
    /// The number of the clip window that tools and panels act on: the chosen one if it is visible,
    /// else the first one that has an effect; empty without a visible window.
    std::optional<std::size_t> windowNumber() const { return windowNumber_; }
    void chooseWindow(std::size_t number);
    /// Whether keys are for that window, not for selected objects or a guide: it was chosen last,
    /// or nothing else is chosen.
    bool windowChosen() const
    {
        return windowNumber_ && !guide && (chosenLast_ || selection_.empty());
    }
    /// Whether it was chosen after the selected objects, by a click or a command.
    bool windowChosenLast() const { return windowNumber_ && !guide && chosenLast_; }
    /// The bounding box of that window, and the frame that its handles stand on.
    const std::optional<clipping::Window>& clipWindow() const { return clipWindow_; }
    const std::optional<WindowFrame>& windowFrame() const { return windowFrame_; }
    /// All current clip windows, including the preview's.
    const ClipWindows& windows() const { return windows_; }
    /// The same for `Scene::clip`.
    const ClipRegion& region() const { return region_; }

    const Display& display() const { return display_; }
    void setDisplay(const Display& display);
    /// `edit` changes a copy of the display, which then replaces it.
    void changeDisplay(const std::invocable<Display&> auto& edit)
    {
        Display display = display_;
        edit(display);
        setDisplay(display);
    }
    /// The variant that clips what is shown: the wanted form if the algorithm has it.
    Variant variant() const { return usable(display_.variant); }
    /// The one that cuts objects: in an export, for good, and for tiles.
    Variant cuts() const { return usable(display_.cuts.value_or(display_.variant)); }
    /// Its functions.
    const clipping::Functions<clipping::Segment, clipping::Window>& uses() const;

    /// Numbers of the selected objects; adjusted after insertions and removals.
    const ObjectRanges& selection() const { return selection_; }
    void select(ObjectRanges objects);
    /// The bounds of the selection; empty if it has no segments. Computed on demand and kept until
    /// the selection or the document changes. Do not call it in slots of EditedDocument::changed:
    /// the scene may not have followed the document yet.
    const std::optional<clipping::Window>& selectionBounds() const;

    /// The line in the inspector: its number in scene.lines(); reset when the scene changes.
    std::optional<std::size_t> inspected() const { return inspected_; }
    void inspect(std::optional<std::size_t> segment);

    /// Opens a drawing: clears history, selection, file name and losses first. `blocks` are those
    /// of a large one (Scene::expect). If memory runs out, the drawing is an empty one without a
    /// file.
    void load(Imported imported, const QString& path = {},
              std::optional<SceneBlockCache> blocks = {});
    QString path() const { return path_; } ///< empty: never saved
    const std::vector<Loss>& losses() const { return losses_; }
    bool mustSaveAs() const; ///< no path, or the import lost something
    /// Saving in two parts, because another thread writes the file (app/session/save.h): the
    /// drawing to write; then, if `path` holds it, its path and saved state. A change in between
    /// stays unsaved; after a load() in between, endSaving() does nothing.
    Document beginSaving();
    void endSaving(const QString& path);

signals:
    void displayChanged();
    /// Also if keys are now for the selection instead of the chosen clip window, or the reverse.
    void selectionChanged();
    void inspectedChanged();
    void previewChanged(); ///< preview(), windows() or windowNumber(), by whatever changes them
    void fileChanged();
    void loaded(); ///< a different drawing: fit the view
    /// Something could not be done; the sentence says what, why, and what to do. Any part of the
    /// program with access to the session may emit it.
    void refused(const QString& sentence);

private:
    void updateWindows();
    void updateChoice();
    /// What refers to parts of the document, and so follows its changes.
    struct Chosen {
        ObjectRanges selection;
        ContainerId layer;
        std::optional<std::size_t> guide;
    };
    Chosen chosenAfter(const DocumentChange& change) const;
    void exchange(Chosen& other) noexcept;
    void follow(const DocumentChange& change);
    void followPage(bool isOther);
    void say(const DocumentChange& change);

    Display display_;
    ObjectRanges selection_;
    bool selectionFollowed_ = false; ///< the selection has changed, and this was not signalled yet
    std::optional<Chosen> chosenBefore_; ///< the last change, in case that it is taken back
    mutable std::optional<std::optional<clipping::Window>> selectionBounds_; ///< as far as known
    std::optional<std::size_t> inspected_;
    Preview preview_;
    // Derived from the document's clip windows or the preview's, whenever these change.
    ClipWindows windows_;
    ClipRegion region_;
    ComparedWindow compared_;
    std::optional<clipping::Window> clipWindow_;
    std::optional<WindowFrame> windowFrame_;
    std::optional<std::size_t> windowNumber_;
    std::size_t chosenWindow_ = 0; ///< may be hidden, or gone
    bool chosenLast_ = false;      ///< a window was chosen after the selected objects
    /// What the page says of lengths, as far as it was followed.
    struct PageMeasure {
        double onPaper = 0, real = 0; ///< millimetres of a user unit
        Unit unit = Unit::Mm;
        friend bool operator==(const PageMeasure&, const PageMeasure&) = default;
    };
    PageMeasure pageMeasure_{};
    QString path_;
    std::vector<Loss> losses_;
    bool saving_ = false; ///< between beginSaving() and endSaving(), without a load()
};

} // namespace app

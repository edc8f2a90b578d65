// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/scene/scene_lines.h"
#include "app/view/painted_part.h"
#include "app/view/plating.h"

namespace app {

/// Makes a plate of the lines of a scene, chunk by chunk in their order. A chunk outside the view
/// costs nothing but a look at its box.
class ScenePlating {
public:
    /// An object is filled if all of it is in `part`, which is what is going to be added.
    ScenePlating(const SceneLines& lines, const PaintedPart& part, const PictureOptions& options,
                 std::size_t expectedPieces);

    /// How what follows is painted; the style must stay as it is.
    void setStyle(const Style& style);
    /// Lines [first, end) of a chunk, whole.
    void addWhole(std::size_t block, std::size_t chunk, std::size_t first, std::size_t end);
    /// Pieces of a chunk.
    void addPieces(std::size_t block, std::span<const clipping::Clipped> pieces);

    Plate take() { return plating_.take(); }

private:
    /// Those of the object that are in one block.
    struct Lines {
        std::size_t block, first, end;
    };

    void goTo(std::size_t block);
    bool skips(const FloatBox& box, std::size_t first, std::size_t end);
    void enter(std::size_t line)
    {
        if (line >= objectEnd_)
            enterObjectOf(line);
    }
    void enterObjectOf(std::size_t line);
    void findObject(std::size_t object);
    bool beginsObject(std::size_t line) const;
    bool isWhole() const;
    double before(std::size_t line);

    const SceneLines& lines_;
    const PaintedPart& part_;
    Plating plating_;
    const Style* style_ = nullptr;
    bool begun_ = false; // the coat for objects that are only stroked

    std::size_t at_ = std::size_t(-1); // the block
    const SceneBlock* block_ = nullptr;

    // The object of the line before. What is about its lines is known if it is filled or dashed.
    std::size_t object_ = std::size_t(-1);
    std::size_t objectEnd_ = 0; // in the block
    bool strokes_ = false;
    std::vector<Lines> objectLines_;
    Outline outline_;
    std::size_t firstLine_ = 0; // in the scene
    LengthsBefore lengths_;
};

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/paper_scene.h"
#include "app/experiment/shaped_window.h"
#include "app/scene/scene_lines.h"

#include <QString>

#include <functional>
#include <vector>

namespace app {

/// Where the lines of an experiment are, and where they are clipped.
struct Field {
    clipping::Window space = paperSpace;
    clipping::Window window = paperWindow;
    /// The window if it is no rectangle along the axes; `window` is its bounding box then.
    std::shared_ptr<const ShapedWindow> shape{};
};

/// The window as `clearcut bench -w` accepts it.
QString windowText(const Field& field);

/// Whether the window has an area and the space has room on all four sides of the window, as every
/// scene of the catalogue needs.
bool hasRoom(const Field& field);

/// Writes the next lines of an unlimited scene. The lines do not depend on how many are requested
/// at a time, so ten million need no more memory than one block.
using LineSource = std::function<void(std::span<clipping::Segment>)>;

/// One row of the catalogue of scenes: lines that depend only on the field and the seed, the same
/// on every machine.
struct TestScene {
    QString key;     ///< for the command line and files; never changes
    QString name;    ///< translated, like the next text
    QString meaning; ///< one sentence
    std::function<LineSource(const Field& field, std::uint64_t seed)> begin;
    std::uint64_t lines = 0; ///< the number of different lines; 0: unlimited
    /// Whether its meaning is true at a window of any shape, not only at a rectangle.
    bool anyShape = false;
};

/// Every scene, in the order of every menu and table; the first is the paper's.
std::vector<TestScene> testScenes();
std::optional<TestScene> findTestScene(QStringView key);

/// The lines of a drawing as a scene, repeated in their order, independent of the seed. There must
/// be at least one line. The scene shares them with the drawing.
TestScene drawingScene(const QString& name, const SceneLines& lines);
/// The same for any lines.
TestScene repeatedScene(const QString& name, std::vector<clipping::Segment> lines);

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/experiment/paper_scene.h"
#include "app/scene/scene_lines.h"

#include <QString>

#include <functional>
#include <vector>

namespace app {

/// Where the lines of an experiment are, and where they are clipped.
struct Field {
    clipping::Window space = paperSpace;
    clipping::Window window = paperWindow;
};

/// Whether the window has an area and the space has room on all four sides of it, as every scene
/// of the catalogue needs.
bool hasRoom(const Field& field);

/// Writes the next lines of a scene, which go on for ever. How many it is asked for at a time does
/// not change them, so ten million need no more memory than a block of them.
using LineSource = std::function<void(std::span<clipping::Segment>)>;

/// One row of the catalogue of scenes: lines that depend on the field and the seed alone, the same
/// on every machine.
struct TestScene {
    QString key;     ///< on the command line and in files; never changes
    QString name;    ///< translated, as is what follows
    QString meaning; ///< one sentence
    std::function<LineSource(const Field& field, std::uint64_t seed)> begin;
    std::uint64_t lines = 0; ///< how many different ones there are; 0: no end of them
};

/// Every scene, in the order of every menu and table; the first is the paper's.
std::vector<TestScene> testScenes();
std::optional<TestScene> findTestScene(QStringView key);

/// The lines of a drawing as a scene, again and again in their order, whatever the seed. They are
/// not empty. It shares them with the drawing.
TestScene drawingScene(const QString& name, const SceneLines& lines);
/// The same of any lines.
TestScene repeatedScene(const QString& name, std::vector<clipping::Segment> lines);

} // namespace app

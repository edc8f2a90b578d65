// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/document/containers.h"

#include <cstddef>

// Limits of a drawing; beyond them the reader refuses the file with one sentence. They are far
// above the needs of real drawings, and low enough that the worst small file ends within seconds
// and needs about a gigabyte. A large file may have as many elements as memory holds.

namespace app::svg {

/// Depth of nested elements, following `use`; recursion to this depth is safe. Written documents
/// never nest deeper: root, containers, style group, object, its title and markup.
constexpr int deepestNesting = 520;
constexpr int deepestNote = 10; ///< depth of markup in the title of an object
static_assert(1 + Containers::deepest + 1 + 1 + 1 + deepestNote <= deepestNesting);
constexpr std::size_t mostBytes = 500'000'000;   ///< bytes read from a pipe, which may never end
constexpr std::size_t mostText = 1'000'000'000;  ///< bytes of attributes and style sheets
constexpr std::size_t mostMetadata = 16'000'000; ///< bytes of title, description and metadata
constexpr std::size_t mostNotes = 50'000'000;    ///< bytes of titles and descriptions of elements
constexpr std::size_t mostNames =
    10'000; ///< different names of elements and attributes; SVG has 400
constexpr std::size_t mostRepeated = 500'000;  ///< elements drawn through `use`
constexpr std::size_t mostLetters = 1'000'000; ///< of texts, with those of boxes
constexpr std::size_t mostBounded = 500'000;   ///< elements of which boxes are computed
/// Shapes, chords and dashes together; in a file with more bytes than this, one for each byte.
constexpr std::size_t mostParts = 10'000'000;
constexpr std::size_t mostDeclarations = 20'000'000; ///< style rules times elements, tested
constexpr std::size_t mostVariableWork = 50'000'000; ///< bytes and steps for variables of CSS
constexpr std::size_t mostDashes = 1'000;            ///< in one pattern
constexpr std::size_t mostGroups =
    Containers::mostContainers - Containers::mostLayers; ///< further groups are dissolved
/// Lines of clip paths and of what they cut, together; in a larger file, one for each byte.
constexpr std::size_t mostClipWork = 3'000'000;
constexpr std::size_t workOfClipElement = 64;    ///< of one in a clip path or mask
constexpr std::size_t mostUnusedClipPaths = 100; ///< whose areas are kept under their ids
constexpr std::size_t mostMaskStroke = 10'000;   ///< points of one whose area is a mask
constexpr std::size_t mostLookedAtStroke =
    1'000; ///< points of one that is looked at beside its line
constexpr std::size_t mostLookedAtStrokes = 100'000; ///< of all whose lines are visible
constexpr double leastWideStroke = 1;                ///< millimetres; how a wider one ends is told
constexpr std::size_t mostClipMeetings = 5'000'000;  ///< places where lines meet
constexpr std::size_t mostNearClips = 200'000'000;   ///< pairs of lines whose boxes meet
constexpr std::size_t mostClipChords = 1'000'000;    ///< of one clip path with curves
/// True curves are met only by clip paths with so many points and chords, and of so many points.
constexpr std::size_t mostTrueClipPoints = 10'000, mostTrueClipChords = 100'000,
                      mostTrueClippedPoints = 1'000'000;
constexpr int mostImages = 500;                                             ///< each may be a layer
constexpr long mostImagePixels = 200'000'000, mostImageBytes = 256'000'000; ///< of all together
constexpr int deepestImages = 5;            ///< SVG images in SVG images
constexpr double largestCoordinate = 1e300; ///< keeps sums and differences finite

} // namespace app::svg

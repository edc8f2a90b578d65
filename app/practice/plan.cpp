// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/practice/plan.h"

#include <algorithm>
#include <array>

namespace app {

namespace {

using Do = MoveKind;

// Cohen-Sutherland
constexpr std::array csPublished{
    PlannedMove{"codes", Do::Bits, "code1"},
    PlannedMove{"codes", Do::Bits, "code2"},
    PlannedMove{"inside", Do::Decide, {}, "beyond"},
    PlannedMove{"top", Do::Edge},
    PlannedMove{"toTop", Do::Place},
    PlannedMove{"toBottom", Do::Place},
    PlannedMove{"toRight", Do::Place},
    PlannedMove{"toLeft", Do::Place},
    PlannedMove{"whose", Do::Line, {}, {}, 2},
    PlannedMove{"move1", Do::Bits, "code1"},
    PlannedMove{"move2", Do::Bits, "code2"},
};
constexpr std::array csCorrected{
    PlannedMove{"codes", Do::Bits, "code[1]"},
    PlannedMove{"codes", Do::Bits, "code[2]"},
    PlannedMove{"outside", Do::Decide, {}, "beyond"},
    PlannedMove{"whose", Do::Line, {}, {}, 2},
    PlannedMove{"top", Do::Edge},
    PlannedMove{"wayToTop", Do::Value, "run", {}, 1},
    PlannedMove{"wayToBottom", Do::Value, "run", {}, 1},
    PlannedMove{"wayToRight", Do::Value, "rise", {}, 1},
    PlannedMove{"wayToLeft", Do::Value, "rise", {}, 1},
    PlannedMove{"toTop", Do::Place},
    PlannedMove{"toBottom", Do::Place},
    PlannedMove{"toRight", Do::Place},
    PlannedMove{"toLeft", Do::Place},
    PlannedMove{"codeAtTop", Do::Bits, "code[1] code[2]"},
    PlannedMove{"codeAtBottom", Do::Bits, "code[1] code[2]"},
    PlannedMove{"codeAtRight", Do::Bits, "code[1] code[2]"},
    PlannedMove{"codeAtLeft", Do::Bits, "code[1] code[2]"},
};

// Liang-Barsky: the ends of the visible part differ between the forms.
constexpr std::array lbPublished{
    PlannedMove{"atLeft", Do::Value, "q"},
    PlannedMove{"atBottom", Do::Value, "q"},
    PlannedMove{"atTop", Do::Value, "q"},
    PlannedMove{"entering", Do::Line, {}, {}, 3},
    PlannedMove{"entry", Do::Value, "r"},
    PlannedMove{"exit", Do::Value, "r"},
    PlannedMove{"tooLate", Do::Decide},
    PlannedMove{"tooEarly", Do::Decide},
    PlannedMove{"beside", Do::Decide},
    PlannedMove{"later", Do::Line, {}, {}, 1},
    PlannedMove{"sooner", Do::Line, {}, {}, 1},
    PlannedMove{"move2", Do::Place},
    PlannedMove{"move1", Do::Place},
};
constexpr std::array lbCorrected{
    PlannedMove{"atLeft", Do::Value, "q"}, PlannedMove{"atBottom", Do::Value, "q"},
    PlannedMove{"atTop", Do::Value, "q"},  PlannedMove{"entering", Do::Line, {}, {}, 3},
    PlannedMove{"entry", Do::Value, "r"},  PlannedMove{"exit", Do::Value, "r"},
    PlannedMove{"tooLate", Do::Decide},    PlannedMove{"tooEarly", Do::Decide},
    PlannedMove{"beside", Do::Decide},     PlannedMove{"end2", Do::Line},
    PlannedMove{"upright2", Do::Place},    PlannedMove{"level2", Do::Place},
    PlannedMove{"end1", Do::Line},         PlannedMove{"upright1", Do::Place},
    PlannedMove{"level1", Do::Place},
};

// Cyrus-Beck
constexpr std::array cbPublished{
    PlannedMove{"normal", Do::Value, "nx", {}, 1},
    PlannedMove{"normal", Do::Value, "ny", {}, 1},
    PlannedMove{"D", Do::Value, "D", {}, 2},
    PlannedMove{"N", Do::Value, "N", {}, 2},
    PlannedMove{"outside", Do::Decide},
    PlannedMove{"t", Do::Value, "t"},
    PlannedMove{"entering", Do::Line, {}, {}, 3},
    PlannedMove{"missed", Do::Decide},
    PlannedMove{"end2", Do::Line},
    PlannedMove{"move2", Do::Place},
    PlannedMove{"move1", Do::Place},
};
constexpr std::array cbCorrected{
    PlannedMove{"D", Do::Value, "D", {}, 2},
    PlannedMove{"N", Do::Value, "N", {}, 2},
    PlannedMove{"outside", Do::Decide},
    PlannedMove{"t", Do::Value, "t"},
    PlannedMove{"entering", Do::Line, {}, {}, 3},
    PlannedMove{"missed", Do::Decide},
    PlannedMove{"end2", Do::Line},
    PlannedMove{"upright2", Do::Place},
    PlannedMove{"level2", Do::Place},
    PlannedMove{"upright1", Do::Place},
    PlannedMove{"level1", Do::Place},
};

// Nicholl-Lee-Nicholl: both forms have the same steps.
constexpr std::array nln{
    PlannedMove{"left", Do::Line},
    PlannedMove{"right", Do::Line},
    PlannedMove{"bothLeft", Do::Decide, {}, "hidden"},
    PlannedMove{"bothAbove", Do::Decide, {}, "hidden"},
    PlannedMove{"leftAbove", Do::Line},
    PlannedMove{"cornerProducts", Do::Value, "pymax"},
    PlannedMove{"cornerProducts", Do::Value, "pxmin"},
    PlannedMove{"cornerMisses", Do::Decide, {}, "hidden"},
    PlannedMove{"notBelow", Do::Edge},
    PlannedMove{"cornerRight", Do::Place},
    PlannedMove{"cornerToBottom", Do::Place},
    PlannedMove{"cornerToRight", Do::Place},
    PlannedMove{"cornerDown", Do::Place},
    PlannedMove{"cornerEnters", Do::Place},
    PlannedMove{"above", Do::Line},
    PlannedMove{"edgeBothLeft", Do::Decide, {}, "hidden"},
    PlannedMove{"edgeBelow", Do::Line},
    PlannedMove{"edgeRight", Do::Edge},
    PlannedMove{"edgeEnters", Do::Place},
    PlannedMove{"bottomProducts", Do::Value, "pxmin"},
    PlannedMove{"bottomProducts", Do::Value, "pymin"},
    PlannedMove{"bottomMisses", Do::Decide, {}, "hidden"},
    PlannedMove{"bottomBeyond", Do::Edge},
    PlannedMove{"bottomToBottom", Do::Place},
    PlannedMove{"bottomToRight", Do::Place},
    PlannedMove{"bottomDown", Do::Place},
    PlannedMove{"bottomEnters", Do::Place},
    PlannedMove{"insideLeft", Do::Edge},
    PlannedMove{"insideToTop", Do::Place},
    PlannedMove{"insideToBottom", Do::Place},
    PlannedMove{"leftDirect", Do::Place},
    PlannedMove{"leftProducts", Do::Value, "pxmin"},
    PlannedMove{"leftProducts", Do::Value, "pymax"},
    PlannedMove{"leftToTop", Do::Line},
    PlannedMove{"leftToLeft", Do::Place},
};

// Skala
constexpr std::array skalaPublished{
    PlannedMove{"codes", Do::Bits, "code1"},
    PlannedMove{"codes", Do::Bits, "code2"},
    PlannedMove{"inside", Do::Decide, {}, "beyond"},
    PlannedMove{"line", Do::Value, "px"},
    PlannedMove{"F", Do::Value, "F", {}, 2},
    PlannedMove{"pattern", Do::Bits, "c"},
    PlannedMove{"missed", Do::Decide},
    PlannedMove{"edges", Do::Edge, "i"},
    PlannedMove{"edges", Do::Edge, "j"},
    PlannedMove{"bothOutside", Do::Line},
    PlannedMove{"moveFirst", Do::Place},
    PlannedMove{"moveSecond", Do::Place},
    PlannedMove{"masked2", Do::Line},
    PlannedMove{"masked1", Do::Line},
    PlannedMove{"move2", Do::Place},
    PlannedMove{"move1", Do::Place},
};
constexpr std::array skalaCorrected{
    PlannedMove{"codes", Do::Bits, "code1"},
    PlannedMove{"codes", Do::Bits, "code2"},
    PlannedMove{"inside", Do::Decide, {}, "beyond"},
    PlannedMove{"f01", Do::Value, "f[0]"},
    PlannedMove{"f01", Do::Value, "f[1]"},
    PlannedMove{"pattern", Do::Bits, "c"},
    PlannedMove{"missed", Do::Decide},
    PlannedMove{"edges", Do::Edge, "i"},
    PlannedMove{"edges", Do::Edge, "j"},
    PlannedMove{"end2", Do::Line},
    PlannedMove{"upright2", Do::Place},
    PlannedMove{"level2", Do::Place},
    PlannedMove{"upright1", Do::Place},
    PlannedMove{"level1", Do::Place},
};

// Kodituwakku-Wijeweera-Chamikara: also horizontal and vertical lines.
constexpr std::array kwcPublished{
    PlannedMove{"notUpright", Do::Line},     PlannedMove{"m", Do::Value, "m"},
    PlannedMove{"c", Do::Value, "c"},        PlannedMove{"left", Do::Edge},
    PlannedMove{"toLeft", Do::Place},        PlannedMove{"toRight", Do::Place},
    PlannedMove{"bottom", Do::Line},         PlannedMove{"toBottom", Do::Place},
    PlannedMove{"toTop", Do::Place},         PlannedMove{"short", Do::Decide},
    PlannedMove{"levelOutside", Do::Decide}, PlannedMove{"levelLeft", Do::Edge},
    PlannedMove{"levelToLeft", Do::Place},   PlannedMove{"levelToRight", Do::Place},
    PlannedMove{"levelShort", Do::Decide},   PlannedMove{"uprightOutside", Do::Decide},
    PlannedMove{"uprightBottom", Do::Edge},  PlannedMove{"uprightToBottom", Do::Place},
    PlannedMove{"uprightToTop", Do::Place},  PlannedMove{"uprightShort", Do::Decide},
};
constexpr std::array kwcCorrected{
    PlannedMove{"notUpright", Do::Line},
    PlannedMove{"left", Do::Edge},
    PlannedMove{"bothLeft", Do::Decide},
    PlannedMove{"bothRight", Do::Decide},
    PlannedMove{"riseToLeft", Do::Value, "rise"},
    PlannedMove{"riseToRight", Do::Value, "rise"},
    PlannedMove{"toLeft", Do::Place},
    PlannedMove{"toRight", Do::Place},
    PlannedMove{"bottom", Do::Line},
    PlannedMove{"bothBelow", Do::Decide},
    PlannedMove{"bothAbove", Do::Decide},
    PlannedMove{"runToBottom", Do::Value, "run"},
    PlannedMove{"runToTop", Do::Value, "run"},
    PlannedMove{"toBottom", Do::Place},
    PlannedMove{"toTop", Do::Place},
    PlannedMove{"levelOutside", Do::Decide},
    PlannedMove{"levelLeft", Do::Edge},
    PlannedMove{"levelToLeft", Do::Place},
    PlannedMove{"levelToRight", Do::Place},
    PlannedMove{"uprightOutside", Do::Decide},
    PlannedMove{"uprightBottom", Do::Edge},
    PlannedMove{"uprightToBottom", Do::Place},
    PlannedMove{"uprightToTop", Do::Place},
};

// Matthes-Drakopoulos: both forms have the same labels.
constexpr std::array md{
    PlannedMove{"besideX", Do::Decide, {}, "besideY", 1},
    PlannedMove{"left", Do::Edge},
    PlannedMove{"riseToLeft", Do::Value, "rise"},
    PlannedMove{"riseToRight", Do::Value, "rise"},
    PlannedMove{"toLeft", Do::Place},
    PlannedMove{"toRight", Do::Place},
    PlannedMove{"bottom", Do::Line},
    PlannedMove{"runToBottom", Do::Value, "run"},
    PlannedMove{"runToTop", Do::Value, "run"},
    PlannedMove{"toBottom", Do::Place},
    PlannedMove{"toTop", Do::Place},
    PlannedMove{"missed", Do::Decide},
};

/// A row: the plans of an algorithm.
struct Plan {
    std::string_view key;
    std::span<const PlannedMove> published, corrected;
};
constexpr std::array plans{
    Plan{"cohen-sutherland", csPublished, csCorrected},
    Plan{"liang-barsky", lbPublished, lbCorrected},
    Plan{"cyrus-beck", cbPublished, cbCorrected},
    Plan{"nicholl-lee-nicholl", nln, nln},
    Plan{"skala", skalaPublished, skalaCorrected},
    Plan{"kodituwakku-wijeweera-chamikara", kwcPublished, kwcCorrected},
    Plan{"matthes-drakopoulos", md, md},
};

} // namespace

std::span<const PlannedMove> planOf(const Variant& variant)
{
    if (!variant.algorithm || variant.misprint)
        return {};
    const auto plan = std::ranges::find(plans, variant.algorithm->key, &Plan::key);
    if (plan == plans.end())
        return {};
    return variant.form == clipping::Form::Published ? plan->published : plan->corrected;
}

std::vector<Variant> practiceVariants()
{
    std::vector<Variant> all;
    for (const Plan& plan : plans)
        for (const auto form : {clipping::Form::Published, clipping::Form::Corrected})
            all.push_back({clipping::findAlgorithm(plan.key), form});
    return all;
}

} // namespace app

// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/teaching/teaching.h"

#include <QCoreApplication>

namespace app {

namespace {

QString sentence(const SentenceContext& context)
{
    return QCoreApplication::translate("sentences", "In line %1: %2")
        .arg(context.step.line)
        .arg(generalSentence(context));
}

constexpr auto variables = std::to_array<VariableUnit>({
    {"u0", ValueUnit::Bare},
    {"u1", ValueUnit::Bare},
    {"p", ValueUnit::Length},
    {"q", ValueUnit::Length},
    {"r", ValueUnit::Bare},
});

} // namespace

extern const Teaching yFirstTeaching;
const Teaching yFirstTeaching{
    .key = "y-first",
    .sentence = sentence,
    .parameter = "r",
    .overlay = bandOverlay,
    .variables = variables,
};

} // namespace app

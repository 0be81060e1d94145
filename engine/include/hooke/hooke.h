#pragma once

#if defined(__cplusplus) && __cplusplus < 202002L && !defined(_MSVC_LANG)
#error "Hooke needs C++20: compile with -std=c++20 or newer"
#endif

/// Everything of Hooke, the mass-spring engine.

#include <hooke/builders.h>
#include <hooke/clock.h>
#include <hooke/effects.h>
#include <hooke/executor.h>
#include <hooke/materials.h>
#include <hooke/methods.h>
#include <hooke/report.h>
#include <hooke/rigid_pose.h>
#include <hooke/scene.h>
#include <hooke/simulation.h>
#include <hooke/stability.h>
#include <hooke/study.h>

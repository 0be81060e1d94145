#pragma once

/// Everything of Hooke, the mass-spring engine.

#include <hooke/builders.h>
#include <hooke/clock.h>
#include <hooke/effects.h>
#include <hooke/executor.h>
#include <hooke/methods.h>
#include <hooke/report.h>
#include <hooke/scene.h>
#include <hooke/simulation.h>

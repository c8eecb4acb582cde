// SPDX-License-Identifier: MIT
#pragma once

// Every component of the engine that people can set, for whoever works on all of them.
#include "engine/ecs/components/camera.h"
#include "engine/ecs/components/day_cycle.h"
#include "engine/ecs/components/gi_settings.h"
#include "engine/ecs/components/lights.h"
#include "engine/ecs/components/material.h"
#include "engine/ecs/components/mesh_instance.h"
#include "engine/ecs/components/model_file.h"
#include "engine/ecs/components/name.h"
#include "engine/ecs/components/shape.h"
#include "engine/ecs/components/transform.h"

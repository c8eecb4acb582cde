// SPDX-License-Identifier: MIT
#include "engine/ecs/access.h"

#include <algorithm>

namespace sl {

namespace {

bool contains(const std::vector<std::type_index>& types, std::type_index type) {
    return std::find(types.begin(), types.end(), type) != types.end();
}

std::string describe(const std::vector<std::type_index>& types, bool everything) {
    if (everything) return "everything";
    std::string text;
    for (const std::type_index type : types) text += (text.empty() ? "" : ", ") + type_name(type);
    return text.empty() ? "-" : text;
}

}  // namespace

void Access::add_read(std::type_index type) {
    if (!contains(reads, type) && !contains(writes, type)) reads.push_back(type);
}

void Access::add_write(std::type_index type) {
    std::erase(reads, type);
    if (!contains(writes, type)) writes.push_back(type);
}

bool Access::reads_type(std::type_index type) const {
    return reads_world || contains(reads, type);
}

bool Access::writes_type(std::type_index type) const {
    return writes_world || contains(writes, type);
}

std::string describe_reads(const Access& access) {
    return describe(access.reads, access.reads_world);
}

std::string describe_writes(const Access& access) {
    return describe(access.writes, access.writes_world);
}

}  // namespace sl

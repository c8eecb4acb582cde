// SPDX-License-Identifier: MIT
#include "tests/hard_cases/hard_case_test.h"

namespace sl {

ResultTable& hard_case_table() {
    static auto* table = static_cast<ResultTable*>(testing::AddGlobalTestEnvironment(new ResultTable(
        "hard cases", SL_DOCS_FOLDER "/hard_cases.md", "case", {"rsm_exact", "rsm_grid", "rsm_disc", "facets", "path_tracer"})));
    return *table;
}
// GoogleTest wants its environments before it runs.
static const ResultTable& registered = hard_case_table();

std::vector<LightMethod> careful_methods() {
    std::vector<LightMethod> methods = small_methods(128);
    for (LightMethod& method : methods) {
        if (auto* disc = method.traced() ? nullptr : method.gi->get_if<RsmDisc>()) disc->samples = 4096;
        if (auto* facets = method.facets() ? method.gi->get_if<Facets>() : nullptr) facets->noise = 0.03f;
        method.samples = 512;
    }
    return methods;
}
INSTANTIATE_TEST_SUITE_P(All, HardCases, testing::ValuesIn(careful_methods()), method_name_of);

}  // namespace sl

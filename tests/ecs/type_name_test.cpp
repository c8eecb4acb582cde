// SPDX-License-Identifier: MIT
#include "engine/ecs/type_name.h"

#include <gtest/gtest.h>

#include <map>

namespace sl_test::inner {
struct Plain {};
template <class T>
struct Boxed {
    struct Part {};
};
}  // namespace sl_test::inner

namespace sl {
namespace {

struct Hidden {};

TEST(TypeName, drops_namespaces) {
    EXPECT_EQ(type_name<sl_test::inner::Plain>(), "Plain");
    EXPECT_EQ(type_name<Hidden>(), "Hidden");
    EXPECT_EQ(type_name<int>(), "int");
}

TEST(TypeName, drops_namespaces_inside_template_arguments) {
    using sl_test::inner::Boxed;
    EXPECT_EQ(type_name<Boxed<Hidden>>(), "Boxed<Hidden>");
    EXPECT_EQ(type_name<Boxed<Boxed<sl_test::inner::Plain>>>(), "Boxed<Boxed<Plain> >");
}

}  // namespace
}  // namespace sl

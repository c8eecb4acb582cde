// SPDX-License-Identifier: MIT
// The number of an invocation among all, where one dimension cannot hold as many work groups (FrameGraph's
// PassBuilder::dispatch_items spreads them over two). Include it after the layout: it reads the size of a group.
uint linear_index() {
    return gl_GlobalInvocationID.y * gl_NumWorkGroups.x * gl_WorkGroupSize.x + gl_GlobalInvocationID.x;
}

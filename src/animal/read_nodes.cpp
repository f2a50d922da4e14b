// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include <cmath>

#include "animal/names.hpp"
#include "animal/read_parts.hpp"

namespace posepack::animal {
namespace {

using base::Issue;
using base::IssueCode;

constexpr std::size_t kMaxNodes = 65'536;
constexpr std::uint32_t kMaxNodeDepth = 4'096;
constexpr double kUnitTolerance = 1e-3;    // of a quaternion's length: beyond it the repair is reported
constexpr double kAffineTolerance = 1e-5;  // of a matrix' bottom row

bool finite(const std::vector<double>& values) {
    for (const double v : values)
        if (!std::isfinite(v)) return false;
    return true;
}

base::Status read_rest(ReadContext& context, const tinygltf::Node& source, const std::string& where,
                       Node& node) {
    const auto sized = [](const std::vector<double>& v, std::size_t n) { return v.empty() || v.size() == n; };
    if (!sized(source.translation, 3) || !sized(source.rotation, 4) || !sized(source.scale, 3) ||
        !sized(source.matrix, 16))
        return Issue{IssueCode::glb_schema, where,
                     "expected 3 numbers of translation and scale, 4 of rotation, 16 of a matrix, found "
                     "another count"};
    if (!finite(source.translation) || !finite(source.rotation) || !finite(source.scale) ||
        !finite(source.matrix))
        return Issue{IssueCode::glb_number, where, "expected finite transforms, found NaN or infinity"};
    if (!source.matrix.empty()) {
        node.has_matrix = true;
        for (int c = 0; c < 4; ++c)
            for (int r = 0; r < 4; ++r)
                node.matrix[c][r] = source.matrix[static_cast<std::size_t>(c * 4 + r)];
        for (int c = 0; c < 4; ++c)
            if (std::abs(node.matrix[c][3] - (c == 3 ? 1.0 : 0.0)) > kAffineTolerance)
                return Issue{IssueCode::glb_ibm, where,
                             "expected an affine matrix (last row 0 0 0 1), found another last row"};
        return {};
    }
    if (!source.translation.empty())
        node.rest.translation = {source.translation[0], source.translation[1], source.translation[2]};
    if (!source.scale.empty()) node.rest.scale = {source.scale[0], source.scale[1], source.scale[2]};
    if (source.rotation.empty()) return {};
    const glm::dvec4 q{source.rotation[0], source.rotation[1], source.rotation[2], source.rotation[3]};
    const double length = std::sqrt(q.x * q.x + q.y * q.y + q.z * q.z + q.w * q.w);
    if (length < 1e-6)
        return Issue{IssueCode::glb_quat, where,
                     fmt::format("expected a unit quaternion, found a rotation of length {:.3g}", length)};
    node.rest.rotation = q / length;
    if (std::abs(length - 1.0) > kUnitTolerance)
        return context.repair(
            IssueCode::warn_quat, IssueCode::glb_quat, where,
            fmt::format("expected a unit quaternion, found a rotation of length {:.4g}", length));
    return {};
}

base::Status link_children(ReadContext& context) {
    auto& nodes = context.animal.nodes;
    for (std::size_t i = 0; i < nodes.size(); ++i)
        for (const int child : context.model().nodes[i].children) {
            const std::string where = fmt::format("nodes/{}/children", i);
            if (child < 0 || static_cast<std::size_t>(child) >= nodes.size())
                return Issue{
                    IssueCode::glb_reference, where,
                    fmt::format("expected children among {} nodes, found index {}", nodes.size(), child)};
            Node& target = nodes[static_cast<std::size_t>(child)];
            if (target.parent != kNone)
                return Issue{IssueCode::glb_node_loop, where,
                             fmt::format("expected one parent for node {}, found nodes {} and {}", child,
                                         target.parent, i)};
            target.parent = static_cast<std::uint32_t>(i);
        }
    return {};
}

// Breadth first from the roots; what is not reached lies on a cycle.
base::Status order_nodes(ReadContext& context) {
    const auto& nodes = context.animal.nodes;
    auto& order = context.animal.node_order;
    std::vector<std::uint32_t> depth(nodes.size(), 0);
    for (std::uint32_t i = 0; i < nodes.size(); ++i)
        if (nodes[i].parent == kNone) order.push_back(i);
    for (std::size_t next = 0; next < order.size(); ++next) {
        const std::uint32_t parent = order[next];
        if (depth[parent] >= kMaxNodeDepth)
            return Issue{IssueCode::lim_node_depth, fmt::format("nodes/{}", parent),
                         fmt::format("expected nodes at most {} deep, found deeper ones", kMaxNodeDepth)};
        for (const int child : context.model().nodes[parent].children) {
            depth[static_cast<std::size_t>(child)] = depth[parent] + 1;
            order.push_back(static_cast<std::uint32_t>(child));
        }
    }
    if (order.size() == nodes.size()) return {};
    std::vector<bool> reached(nodes.size(), false);
    for (const std::uint32_t i : order) reached[i] = true;
    std::uint32_t on_cycle = 0;
    while (reached[on_cycle]) ++on_cycle;
    return Issue{IssueCode::glb_node_loop, fmt::format("nodes/{}", on_cycle),
                 "expected parents that end at a root, found a cycle"};
}

}  // namespace

base::Status read_nodes(ReadContext& context) {
    const auto& sources = context.model().nodes;
    if (sources.size() > kMaxNodes)
        return Issue{IssueCode::lim_count, "nodes",
                     fmt::format("expected at most {} nodes, found {}", kMaxNodes, sources.size())};
    context.animal.nodes.resize(sources.size());
    for (std::size_t i = 0; i < sources.size(); ++i) {
        const std::string where = fmt::format("nodes/{}", i);
        auto name = usable_name(sources[i].name, fmt::format("node_{}", i));
        if (!name) return base::at(where, name.issue());
        context.animal.nodes[i].name = std::move(name).value();
        if (auto status = read_rest(context, sources[i], where, context.animal.nodes[i]); !status)
            return status;
    }
    if (auto status = link_children(context); !status) return status;
    return order_nodes(context);
}

}  // namespace posepack::animal

// SPDX-License-Identifier: MIT
// A smooth field of lines (directions without a sign) on even samples of a surface.
//   link_samples: samples -> a graph of neighbours on the same sheet, each with a tangent frame
//   line_angles: curvature, a law with a name or the caller's directions -> the smoothest field that follows them where
//                they are sure                                                              [Knoeppel et al. 2013]
#pragma once

#include "hatching/links.h"
#include "marks/site.h"

namespace hrbfnpr::hatching {

// What lines follow. The numbers are those that hrbfnpr_layer_desc.guide takes.
enum class Guide : std::uint32_t { curvature = 0, combing = 1, sections = 2, light = 3, silhouette = 4 };

struct FieldSettings {
    double smoothing = 0.04;        // the length over which lines are smoothed, in diagonals
    glm::dvec3 axis{0.0, 1.0, 0.0}; // where curvature says little lines run across this, around it
    double axis_weight = 0.06;      // how much the axis counts against curvature
    Guide guide = Guide::curvature;
    glm::dvec3 guide_direction{0.0, 0.0, 1.0}; // unit: to the light, or to the eye
    double guide_weight = 1.0;                 // the share of `guide`; curvature has the rest
    double diagonal = 1.0;
};

// Even samples of the surface; the graph's links lead over no crease and to no other sheet.
struct SampleGraph : Graph {
    explicit SampleGraph(base::Memory& memory) noexcept
        : Graph(memory), position(memory), normal(memory), sheet(memory), u(memory) {}

    // The unit tangent at this angle in the frame of sample i, and the angle of a tangent there.
    [[nodiscard]] glm::dvec3 tangent(std::int64_t i, double angle) const noexcept {
        return std::cos(angle) * u[i] + std::sin(angle) * glm::cross(normal[i], u[i]);
    }
    [[nodiscard]] double angle(std::int64_t i, const glm::dvec3& tangent) const noexcept {
        return std::atan2(glm::dot(tangent, glm::cross(normal[i], u[i])), glm::dot(tangent, u[i]));
    }

    geometry::VecArray position, normal;
    base::Array<std::int32_t> sheet; // the implicit's sheet at each sample; empty: the surface is smooth
    geometry::VecArray u;            // the first axis of each sample's frame; the second is normal x u
    double spacing = 0.0;            // the root of the area for each sample
};

// Links the samples, whose positions, normals, sheets and spacing are there.
void link_samples(const base::Runtime& runtime, SampleGraph& graph, const base::Progress& progress);

// The line along the larger of both principal curvatures by amount, of which this is the mean and half the difference,
// as exp(2 i angle) times how sure it is, from 0 to 1.
[[nodiscard]] Complex curvature_line(double mean, const Complex& difference, double diagonal) noexcept;

// The angle of the line of each sample in its frame. The function, if there is one, takes the place of curvature.
[[nodiscard]] base::Array<double> line_angles(const marks::Site& site, const SampleGraph& graph,
                                              const FieldSettings& settings, const marks::DirectionFunction& function,
                                              const base::Progress& progress);

} // namespace hrbfnpr::hatching

// SPDX-License-Identifier: MIT
#include "mesh/plan.h"

#include <gtest/gtest.h>

#include <limits>

namespace plan_test {

namespace mesh = hrbfnpr::mesh;
using mesh::Edges;
using mesh::EdgesInFile;
using Choice = mesh::CoarsePlan::Choice;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

bool never() {
    ADD_FAILURE() << "the plan asked for a fact that it does not need";
    return false;
}

// ---- Faces that look the wrong way

TEST(Plan, TurnsInsideOutParts) {
    using mesh::Faces;
    using mesh::Parts;
    mesh::Component component;
    component.area = 1.0;
    component.volume = -1.0;
    EXPECT_TRUE(mesh::is_turned(component, Parts::all, Faces::turn));
    EXPECT_FALSE(mesh::is_turned(component, Parts::all, Faces::keep));
    component.around = 1; // a cavity
    EXPECT_FALSE(mesh::is_turned(component, Parts::all, Faces::turn));
    component.volume = 1.0;
    EXPECT_TRUE(mesh::is_turned(component, Parts::all, Faces::turn));
    EXPECT_TRUE(mesh::is_turned(component, Parts::solids, Faces::turn));
    EXPECT_FALSE(mesh::is_turned(component, Parts::solids, Faces::keep));
    EXPECT_FALSE(mesh::is_turned(component, Parts::outer, Faces::turn));
    component.around = 2; // a solid in a cavity
    EXPECT_FALSE(mesh::is_turned(component, Parts::solids, Faces::turn));
    component.volume = -1.0;
    EXPECT_TRUE(mesh::is_turned(component, Parts::solids, Faces::turn));
    EXPECT_TRUE(mesh::is_turned(component, Parts::outer, Faces::turn));
    component.closed = false;
    component.holes = 0.2;
    EXPECT_TRUE(mesh::is_turned(component, Parts::outer, Faces::turn));
    component.holes = 0.3; // the holes are too large for it to have an inside
    EXPECT_FALSE(mesh::is_turned(component, Parts::outer, Faces::turn));
}

TEST(Plan, TurnsAnOpenMesh) {
    const auto facing = [](char hangs, bool inward) {
        return mesh::plan_facing({false, [=] { return hangs; }, [=] { return inward; }}, false);
    };
    EXPECT_EQ(facing(0, false), mesh::Facing::right);
    EXPECT_EQ(facing(0, true), mesh::Facing::inward);
    EXPECT_EQ(facing('z', true), mesh::Facing::down_z);
    EXPECT_EQ(facing('y', false), mesh::Facing::down_y);
    const auto asked = [] { return never() ? 'z' : 'y'; };
    EXPECT_EQ(mesh::plan_facing({true, asked, never}, false), mesh::Facing::right);
    EXPECT_EQ(mesh::plan_facing({false, asked, never}, true), mesh::Facing::right);
}

// ---- Edges that stand out

TEST(Plan, EdgesAreSharpIfTheyStandOut) {
    EXPECT_FALSE(mesh::judge_edges({0.0, 0.0, 0.0}, 1.0).creases);
    EXPECT_FALSE(mesh::judge_edges({1.0, 0.49, 0.0}, 1.0).creases);
    EXPECT_TRUE(mesh::judge_edges({1.0, 0.5, 0.0}, 1.0).creases);
    EXPECT_FALSE(mesh::judge_edges({1.0, 0.5, 0.9}, 1.0).polyhedron);
    EXPECT_TRUE(mesh::judge_edges({1.0, 0.1, 0.25}, 1.0).polyhedron);
    EXPECT_FALSE(mesh::judge_edges({0.04, 0.04, 0.0}, 1.0).creases); // too short
    const mesh::CreaseEvidence found = mesh::judge_edges({4.0, 1.0, 2.0}, 2.0);
    EXPECT_EQ(found.length, 2.0);
    EXPECT_EQ(found.standing, 0.25);
    EXPECT_EQ(found.coarse, 0.5);
}

TEST(Plan, EdgesOfEnoughAreaCountForTheWholeMesh) {
    EXPECT_FALSE(mesh::judge_all_edges({1.0, 1.0, 0.0}, 1.0, 0.09, 1.0).creases);
    EXPECT_TRUE(mesh::judge_all_edges({1.0, 0.0, 0.0}, 1.0, 0.1, 1.0).creases);
    EXPECT_FALSE(mesh::judge_all_edges({}, 1.0, 0.0, 0.0).creases);
}

TEST(Plan, EdgesFollowTheWishOrTheShape) {
    mesh::CreaseEvidence found;
    EXPECT_EQ(mesh::plan_edges(Edges::smooth, found, never), mesh::SharpEdges::none);
    EXPECT_EQ(mesh::plan_edges(Edges::sharp, found, never), mesh::SharpEdges::bending);
    EXPECT_EQ(mesh::plan_edges(Edges::automatic, found, [] { return false; }), mesh::SharpEdges::none);
    EXPECT_EQ(mesh::plan_edges(Edges::automatic, found, [] { return true; }), mesh::SharpEdges::meant);
    found.creases = true;
    EXPECT_EQ(mesh::plan_edges(Edges::automatic, found, never), mesh::SharpEdges::meant);
}

TEST(Plan, EachPartHasItsOwnSharpness) {
    mesh::CreaseEvidence part, whole;
    whole.standing = 0.6;
    EXPECT_EQ(mesh::plan_sharpness(part, whole, 30.0, 5.0, 1.0).angle, 180.0);
    EXPECT_EQ(mesh::plan_sharpness(part, whole, 30.0, 5.0, 1.0).coarse, 1.0);
    whole.standing = 0.4;
    EXPECT_EQ(mesh::plan_sharpness(part, whole, 30.0, 5.0, 1.0).coarse, std::numeric_limits<double>::infinity());
    part.creases = true;
    EXPECT_EQ(mesh::plan_sharpness(part, whole, 30.0, 5.0, 1.0).angle, 30.0);
    EXPECT_EQ(mesh::plan_sharpness(part, whole, 30.0, 5.0, 1.0).coarse, mesh::plan_sharpness(30.0, 5.0).coarse);
    part.polyhedron = true;
    EXPECT_EQ(mesh::plan_sharpness(part, whole, 30.0, 5.0, 1.0).angle, 1.5);
}

// ---- Coarse faces

TEST(Plan, APartOfCrumbsIsSmooth) {
    EXPECT_TRUE(mesh::is_crumbled({1000, 0.5}, 1.0));
    EXPECT_FALSE(mesh::is_crumbled({999, 1.0}, 1.0));   // few sheets take little time
    EXPECT_FALSE(mesh::is_crumbled({5000, 0.49}, 1.0)); // most of the area has larger sheets
    EXPECT_EQ(mesh::plan_crumbled().angle, 180.0);
}

TEST(Plan, AFileSaysWhichEdgesAreSharp) {
    EXPECT_EQ(mesh::plan_edges_of_file(7, 7), EdgesInFile::nothing);
    EXPECT_EQ(mesh::plan_edges_of_file(100, 98), EdgesInFile::all_are_sharp);
    EXPECT_EQ(mesh::plan_edges_of_file(100, 97), EdgesInFile::some_are_sharp);
    EXPECT_EQ(mesh::plan_edges_of_file(100, 3), EdgesInFile::some_are_sharp);
    EXPECT_EQ(mesh::plan_edges_of_file(100, 2), EdgesInFile::nothing);
}

struct Coarse {
    mesh::CoarseFacts facts;
    mesh::MeshOptions wishes;

    explicit Coarse(double off, EdgesInFile said = EdgesInFile::nothing) {
        facts.faces = 100;
        facts.said = said;
        facts.mean_edge = [] { return 0.1; };
        facts.coarseness = [off] { return off; };
        facts.has_creases = [] { return false; };
    }
    [[nodiscard]] mesh::CoarsePlan plan() const { return mesh::plan_coarse_faces(facts, wishes); }
};

TEST(Plan, DividesCoarseFacesUntilTheyAreFine) {
    EXPECT_EQ(Coarse(0.002).plan().choice, Choice::nothing);
    EXPECT_EQ(Coarse(nan).plan().choice, Choice::nothing);
    EXPECT_EQ(Coarse(0.0021).plan().rounds, 1);
    EXPECT_EQ(Coarse(0.0039).plan().rounds, 1);
    EXPECT_EQ(Coarse(0.0041).plan().rounds, 2);
    EXPECT_EQ(Coarse(1.0).plan().rounds, 3);
    EXPECT_EQ(Coarse(1.0).plan().choice, Choice::divided);
    Coarse rough(0.01);
    rough.wishes.tolerance = 0.02;
    EXPECT_EQ(rough.plan().choice, Choice::nothing);
}

TEST(Plan, KeepsFacesThatShouldNotBeDivided) {
    Coarse coarse(0.01);
    coarse.facts.has_creases = [] { return true; };
    EXPECT_EQ(coarse.plan().choice, Choice::nothing);
    coarse.facts.said = EdgesInFile::some_are_sharp; // now edges that stand out do not matter
    EXPECT_EQ(coarse.plan().choice, Choice::divided);
    EXPECT_TRUE(coarse.plan().parts_alone);
    coarse = Coarse(0.01);
    coarse.facts.mean_edge = [] { return 0.02; };
    coarse.facts.has_creases = never;
    EXPECT_EQ(coarse.plan().choice, Choice::nothing);
    coarse.facts.mean_edge = [] { return never() ? 0.0 : 1.0; };
    coarse.facts.faces = 50'001;
    EXPECT_EQ(coarse.plan().choice, Choice::nothing);
    coarse.facts.faces = 100;
    coarse.wishes.chooses_samples = false;
    EXPECT_EQ(coarse.plan().choice, Choice::nothing);
    coarse.wishes.chooses_samples = true;
    coarse.wishes.edges_as_given = false;
    coarse.wishes.edges = Edges::sharp;
    EXPECT_EQ(coarse.plan().choice, Choice::nothing);
    coarse.wishes.rounds = 2; // the caller's number of rounds wins
    EXPECT_EQ(coarse.plan().choice, Choice::divided);
    EXPECT_EQ(coarse.plan().rounds, 2);
    coarse.wishes.rounds = 0;
    EXPECT_EQ(coarse.plan().choice, Choice::nothing);
}

TEST(Plan, AllFacesAreFlatIfTheFileSaysSo) {
    Coarse coarse(0.01, EdgesInFile::all_are_sharp);
    EXPECT_EQ(coarse.plan().choice, Choice::all_flat);
    EXPECT_TRUE(coarse.plan().is_flat());
    coarse.wishes.rounds = 1;
    EXPECT_EQ(coarse.plan().choice, Choice::divided);
}

TEST(Plan, ADivisionThatFoldsIsRejected) {
    mesh::MeshOptions wishes;
    const auto judge = [&](double moved, double raised, EdgesInFile said) {
        return mesh::judge_division({moved, raised, 0.01, [] { return 0.02; }}, said, wishes);
    };
    EXPECT_EQ(judge(0.015, 0.03, EdgesInFile::nothing), Choice::divided);
    EXPECT_EQ(judge(0.016, 0.0, EdgesInFile::nothing), Choice::coarse_flat);
    EXPECT_EQ(judge(0.0, 0.031, EdgesInFile::nothing), Choice::coarse_flat);
    EXPECT_EQ(judge(0.029, 1.0, EdgesInFile::some_are_sharp), Choice::divided);
    EXPECT_EQ(judge(0.031, 0.0, EdgesInFile::some_are_sharp), Choice::nothing);
    wishes.edges_as_given = false; // for example AUTO or SMOOTH
    EXPECT_EQ(judge(0.016, 0.0, EdgesInFile::nothing), Choice::divided);
    wishes.rounds = 1;
    EXPECT_EQ(judge(1.0, 1.0, EdgesInFile::some_are_sharp), Choice::divided);
}

TEST(Plan, TheFitKeepsTheWishedEdges) {
    mesh::MeshOptions wishes;
    const mesh::FittedEdges of_fit{Edges::automatic, 40.0};
    EXPECT_EQ(mesh::plan_fitted_edges(of_fit, wishes, false).angle, 40.0);
    EXPECT_EQ(mesh::plan_fitted_edges(of_fit, wishes, true).edges, Edges::sharp);
    EXPECT_EQ(mesh::plan_fitted_edges(of_fit, wishes, true).angle, 5.0);
    wishes.edges_as_given = false;
    wishes.edges = Edges::smooth;
    wishes.edge_angle = 20.0;
    EXPECT_EQ(mesh::plan_fitted_edges(of_fit, wishes, true).edges, Edges::smooth);
    EXPECT_EQ(mesh::plan_fitted_edges(of_fit, wishes, true).angle, 30.0);
    wishes.edges = Edges::sharp;
    EXPECT_EQ(mesh::plan_fitted_edges(of_fit, wishes, true).angle, 20.0);
}

// ---- Parts

TEST(Plan, LeavesOutPartsInsideOthersAndFarAway) {
    using mesh::Parts;
    mesh::Component nested;
    nested.around = 1;
    EXPECT_FALSE(mesh::is_kept(nested, false, Parts::outer));
    EXPECT_TRUE(mesh::is_kept(nested, false, Parts::all));
    EXPECT_TRUE(mesh::is_kept(nested, false, Parts::solids));
    EXPECT_FALSE(mesh::is_kept(nested, false, Parts::automatic));
    nested.closed = false;
    EXPECT_FALSE(mesh::is_kept(nested, false, Parts::solids));
    EXPECT_FALSE(mesh::is_kept({}, false, Parts::largest));
    EXPECT_TRUE(mesh::is_kept(nested, true, Parts::largest));
    EXPECT_TRUE(mesh::is_kept({}, false, Parts::outer));
    EXPECT_TRUE(mesh::is_crumb(0.0009, 1.0));
    EXPECT_FALSE(mesh::is_crumb(0.001, 1.0));
    EXPECT_TRUE(mesh::is_lost(3.1));
    EXPECT_FALSE(mesh::is_lost(3.0));
    EXPECT_TRUE(mesh::is_flap(2, 1e-4, 1.0));
    EXPECT_FALSE(mesh::is_flap(3, 1e-4, 1.0));
    EXPECT_FALSE(mesh::is_flap(2, 3e-4, 1.0));
}

TEST(Plan, OpenPartsMayBeGrouped) {
    mesh::MeshReport report;
    report.components = 2;
    EXPECT_FALSE(mesh::may_be_grouped(report, 100));
    report.boundary_edges = 1;
    EXPECT_TRUE(mesh::may_be_grouped(report, 300'000));
    report.components = 1;
    EXPECT_FALSE(mesh::may_be_grouped(report, 300'000));
    EXPECT_TRUE(mesh::may_be_grouped(report, 100'000));
}

// ---- Accuracy of the fit

TEST(Plan, AFitChoosesItsSamplesUnlessTheCallerDoes) {
    EXPECT_TRUE(mesh::chooses_samples({}));
    EXPECT_FALSE(mesh::chooses_samples({true, false, false, false, false}));
    EXPECT_FALSE(mesh::chooses_samples({false, false, false, false, true}));
}

TEST(Plan, TolerancesFollowTheWish) {
    EXPECT_EQ(mesh::plan_tolerance(0.0, 10.0), 0.02);
    EXPECT_EQ(mesh::plan_tolerance(0.5, 10.0), 0.5);
    EXPECT_EQ(mesh::plan_far(0.0, 0.5), 2.5);
    EXPECT_EQ(mesh::plan_far(1.0, 0.5), 1.0);
    EXPECT_EQ(mesh::plan_tolerance_of_group(1.0, 4.0), 0.004);
}

// ---- Where the surface ends

TEST(Plan, AClosedSurfaceEndsWhereTheFitInventsParts) {
    mesh::EndFacts facts;
    facts.mesh_p99 = facts.surface_p99 = 0.001;
    facts.surface_most = 0.01;
    EXPECT_EQ(mesh::plan_end(facts, true).end, mesh::End::at_samples);
    facts.reached = true;
    EXPECT_EQ(mesh::plan_end(facts, true).end, mesh::End::nowhere);
    facts.has_creases = true;
    EXPECT_EQ(mesh::plan_end(facts, true).end, mesh::End::at_places);
    facts.surface_most = 0.008;
    EXPECT_EQ(mesh::plan_end(facts, true).end, mesh::End::nowhere);
    facts.mesh_p99 = facts.surface_p99 = facts.surface_most = nan;
    EXPECT_EQ(mesh::plan_end(facts, true).end, mesh::End::nowhere);
    EXPECT_EQ(mesh::plan_end(facts, true).off, 0.009);
}

TEST(Plan, APictureEndsWhereTheMeshDoes) {
    mesh::EndFacts facts;
    facts.surface_most = 0.008;
    facts.closed = true;
    const auto end = [&] { return mesh::plan_end_of_picture(facts, true).end; };
    EXPECT_EQ(end(), mesh::End::nowhere);
    facts.closed = false;
    EXPECT_EQ(end(), mesh::End::nowhere);
    facts.has_creases = true;
    EXPECT_EQ(end(), mesh::End::at_places);
    facts.closed = true;
    EXPECT_EQ(end(), mesh::End::nowhere);
    facts.surface_most = 0.01;
    EXPECT_EQ(end(), mesh::End::at_places);
    facts.has_creases = false;
    EXPECT_EQ(end(), mesh::End::at_places);
    facts.surface_most = nan;
    EXPECT_EQ(end(), mesh::End::at_places);
    facts.has_border = true;
    EXPECT_EQ(end(), mesh::End::as_fitted);
    EXPECT_EQ(mesh::plan_end_of_samples(0.01, 10.0, true).off, 0.009);
    EXPECT_DOUBLE_EQ(mesh::plan_end_of_samples(0.1, 1.0, true).off, 0.15);
}

TEST(Plan, AKeptSurfaceIsNotTrimmed) {
    mesh::EndFacts facts;
    facts.has_border = true;
    EXPECT_EQ(mesh::plan_end(facts, false).end, mesh::End::nowhere);
    EXPECT_EQ(mesh::plan_end_of_picture(facts, false).end, mesh::End::nowhere);
    EXPECT_EQ(mesh::plan_end_of_samples(0.1, 1.0, false).end, mesh::End::nowhere);
}

TEST(Plan, CoarseFacesMoveTheEndFartherOut) {
    mesh::EndFacts facts;
    const auto off = [&](double p99) {
        facts.mesh_p99 = facts.surface_p99 = p99;
        return mesh::plan_end(facts, true).off;
    };
    EXPECT_EQ(off(0.001), 0.009);
    EXPECT_DOUBLE_EQ(off(0.008), 0.012);
    EXPECT_EQ(off(1.0), 0.015);
    facts.area = 0.02; // An open mesh that is fitted well has sharp corners.
    facts.border = 2.0;
    EXPECT_DOUBLE_EQ(off(1e-6), 0.001);
    EXPECT_DOUBLE_EQ(off(1e-3), 0.005);
    facts.border = 1000.0; // A long border has fewer places, unless it bounds narrow strips.
    EXPECT_DOUBLE_EQ(off(1e-6), 0.001);
    facts.area = 50.0;
    EXPECT_DOUBLE_EQ(off(1e-6), 1000.0 * 0.15 / 40000.0);
}

} // namespace
} // namespace plan_test

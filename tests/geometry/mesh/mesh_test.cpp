// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/mesh/mesh.hpp"

#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>

#include "geometry/brep/input_error.hpp"
#include "geometry/mesh/mesh_shells.hpp"
#include "geometry/mesh/mesh_weld.hpp"
#include "tests/geometry/mesh/small_meshes.hpp"

namespace abut::geometry::mesh_test {
namespace {

MeshFile read(const std::string& name, const std::string& bytes) {
    const TemporaryFile file(name, bytes);
    return read_mesh_file(file.path());
}

std::string refusal(const std::string& name, const std::string& bytes) {
    try {
        read(name, bytes);
    } catch (const InputError& error) {
        EXPECT_EQ(error.problems().size(), 1u);
        const std::string line = one_line(error.problems().front());
        EXPECT_EQ(line.find('\n'), std::string::npos) << line;
        return line;
    }
    return "";
}

std::vector<std::string> names_of(const MeshFile& file) {
    std::vector<std::string> names;
    for (const Mesh& body : file.bodies) names.push_back(body.name);
    return names;
}

bool has_repair(const MeshFile& file, const std::string& text) {
    return std::any_of(file.repairs.begin(), file.repairs.end(),
                       [&](const Repair& repair) { return repair.what.find(text) != std::string::npos; });
}

/// Every triangle with vertices of its own.
Mesh exploded(const Mesh& mesh) {
    Mesh soup{mesh.name, {}, {}};
    for (const auto& t : mesh.triangles) {
        const int n = static_cast<int>(soup.vertices.size());
        for (int i : t) soup.vertices.push_back(mesh.vertices[static_cast<std::size_t>(i)]);
        soup.triangles.push_back({n, n + 1, n + 2});
    }
    return soup;
}

const Mesh unit_box = box({0, 0, 0}, {1, 1, 1});

TEST(Mesh, VerticesAreJoinedAndWhatIsLeftWithoutMeaningGoes) {
    Mesh soup = exploded(unit_box);
    soup.vertices[4] += Vec3(3e-7, 0, 0);              // rounding of the file
    soup.triangles.push_back(soup.triangles.front());  // doubled
    soup.triangles.push_back({0, 1, 1});               // without area
    const Weld done = weld(soup);
    EXPECT_EQ(soup.vertices.size(), 8u);
    EXPECT_EQ(soup.triangles.size(), 12u);
    EXPECT_EQ(done.n_joined, 1);
    EXPECT_NEAR(done.moved, 3e-7, 1e-12);
    EXPECT_EQ(done.n_degenerate, 1);
    EXPECT_EQ(done.n_doubled, 1);
}

/// In clusters of about the weld length, wherever the cells of the search lie: as by comparing each with all.
TEST(Mesh, VerticesJoinTheNearestOneBeforeThem) {
    std::mt19937 random(6);
    std::uniform_real_distribution<double> unit(-1, 1);
    for (int trial = 0; trial < 20; ++trial) {
        Mesh mesh{"", {{-50, -50, -50}, {50, 50, 50}}, {}};
        const double length = weld_length(mesh.vertices);
        for (int cluster = 0; cluster < 20; ++cluster) {
            const Vec3 center = 40 * Vec3(unit(random), unit(random), unit(random));
            for (int k = 0; k < 15; ++k)
                mesh.vertices.push_back(center + 3 * length * Vec3(unit(random), unit(random), unit(random)));
        }
        std::vector<Vec3> kept;
        for (const Vec3& v : mesh.vertices)
            if (std::none_of(kept.begin(), kept.end(), [&](const Vec3& other) { return (other - v).norm() <= length; }))
                kept.push_back(v);
        for (int k = 2; k < static_cast<int>(mesh.vertices.size()); ++k) mesh.triangles.push_back({0, 1, k});  // all are used
        const std::vector<Vec3> given = mesh.vertices;
        weld(mesh);
        EXPECT_EQ(mesh.vertices, kept) << trial;
        EXPECT_LT(kept.size(), given.size() - 20);
    }
}

TEST(Mesh, VerticesFartherApartThanTheWeldLengthStayTwo) {
    Mesh soup = exploded(unit_box);
    soup.vertices[4] += Vec3(3e-6, 0, 0);
    weld(soup);
    EXPECT_EQ(soup.vertices.size(), 9u);
}

TEST(Mesh, ABodyFarFromTheOriginIsJoinedWithinItsRounding) {
    Mesh soup = exploded(box({1e5, 1e5, 0}, {1e5 + 1, 1e5 + 1, 1}));
    soup.vertices[4].x() += 8e-3;  // one step of single precision there
    weld(soup);
    EXPECT_EQ(soup.vertices.size(), 8u);
}

TEST(Mesh, TurnedTrianglesAndShellsInsideOutAreMended) {
    std::mt19937 random(1);
    for (int round = 0; round < 50; ++round) {
        Mesh mesh = prism(regular_polygon({2, 3}, 5, 12), -1, 1);
        const double volume = signed_volume(mesh);
        ASSERT_GT(volume, 0);
        for (auto& t : mesh.triangles)
            if (random() % 3 == 0) std::swap(t[0], t[1]);
        if (round % 2 == 0) turn_inside_out(mesh);
        const MeshFile file = bodies_of({mesh});
        ASSERT_EQ(file.bodies.size(), 1u);
        EXPECT_NEAR(signed_volume(file.bodies[0]), volume, 1e-12 * volume);
        EXPECT_TRUE(has_repair(file, "turned"));
        EXPECT_TRUE(file.problems.empty());
    }
}

TEST(Mesh, DisjointShellsBecomeBodies) {
    const Mesh far = box({3, 0, 0}, {4, 1, 1});
    EXPECT_EQ(names_of(bodies_of({together(unit_box, far)})), (std::vector<std::string>{"shell1", "shell2"}));
    Mesh named = together(unit_box, far);
    named.name = "pair";
    EXPECT_EQ(names_of(bodies_of({named})), (std::vector<std::string>{"pair#0", "pair#1"}));
}

TEST(Mesh, NamesAreUnique) {
    Mesh bolt = unit_box, tricky = unit_box;
    bolt.name = "bolt";
    tricky.name = "bolt#1";
    EXPECT_EQ(names_of(bodies_of({bolt, tricky, bolt, unit_box, bolt})),
              (std::vector<std::string>{"bolt", "bolt#1", "bolt#2", "shell1", "bolt#3"}));
}

TEST(Mesh, ACavityBelongsToTheBodyAroundItAndAPartInsideDoesNot) {
    Mesh outer = box({0, 0, 0}, {9, 9, 9}), inner = box({3, 3, 3}, {6, 6, 6});
    EXPECT_EQ(bodies_of({together(outer, inner)}).bodies.size(), 2u);
    turn_inside_out(inner);
    const MeshFile file = bodies_of({together(outer, inner)});
    ASSERT_EQ(file.bodies.size(), 1u);
    EXPECT_NEAR(signed_volume(file.bodies[0]), 729 - 27, 1e-9);
    const MeshFile beside = bodies_of({together(box({20, 0, 0}, {29, 9, 9}), inner)});
    ASSERT_EQ(beside.bodies.size(), 2u) << "inside out, but in nothing";
    EXPECT_NEAR(signed_volume(beside.bodies[1]), 27, 1e-9);
}

/// Boxes that share a face, an edge, or a face and its triangles turned about: two bodies wherever both sides are in the file.
TEST(Mesh, TouchingBodiesOfOneSoupAreToldApart) {
    const std::vector<std::pair<Vec3, std::string>> places = {{{1, 0, 0}, "face"}, {{0, 1, 0}, "face"},  {{0, 0, 1}, "face"},
                                                              {{1, 1, 0}, "edge"}, {{-1, 1, 0}, "edge"}, {{0, -1, 1}, "edge"}};
    for (bool inside_out : {false, true})
        for (const auto& [shift, what] : places) {
            Mesh soup = together(unit_box, box(shift, shift + Vec3(1, 1, 1)));
            if (inside_out) turn_inside_out(soup);
            const MeshFile file = bodies_of({exploded(soup)});
            ASSERT_EQ(file.bodies.size(), 2u) << what << " " << shift.transpose();
            for (const Mesh& body : file.bodies) EXPECT_NEAR(signed_volume(body), 1, 1e-12);
            EXPECT_TRUE(file.problems.empty());
            EXPECT_TRUE(has_repair(file, "told apart"));
        }
}

TEST(Mesh, AFaceSharedOnceIsAProblemWithPlaceAndHint) {
    Mesh soup = together(unit_box, box({1, 0, 0}, {2, 1, 1}));
    weld(soup);
    // The common face once only: no exporter's solid has it, soups of surfaces do.
    std::erase_if(soup.triangles, [&](const auto& t) {
        const auto on = [&](int i) { return soup.vertices[static_cast<std::size_t>(i)].x() == 1; };
        const auto at = [&](std::size_t k) { return soup.vertices[static_cast<std::size_t>(t[k])]; };
        return on(t[0]) && on(t[1]) && on(t[2]) && (at(1) - at(0)).cross(at(2) - at(0)).x() < 0;
    });
    ASSERT_EQ(soup.triangles.size(), 22u);
    const MeshFile file = bodies_of({soup});
    ASSERT_EQ(file.bodies.size(), 1u);
    ASSERT_EQ(file.problems.size(), 1u);
    EXPECT_NE(file.problems[0].what.find("cannot be told apart: 4 edges"), std::string::npos) << file.problems[0].what;
    EXPECT_EQ(file.problems[0].hint, "export the parts as separate objects");
    EXPECT_EQ(file.problems[0].at.x(), 1);
}

TEST(Mesh, AHoleIsAProblemWithPlace) {
    Mesh open = unit_box;
    open.triangles.pop_back();
    const MeshFile file = bodies_of({open});
    ASSERT_EQ(file.problems.size(), 1u);
    EXPECT_NE(file.problems[0].what.find("3 edges with a triangle on one side only"), std::string::npos)
        << file.problems[0].what;
    EXPECT_EQ(file.problems[0].entity, "shell1");
}

TEST(Mesh, EveryFormatGivesTheSameBody) {
    const Mesh given = prism(regular_polygon({2, 3}, 5, 12), -1, 1, "knob");
    const std::vector<std::tuple<std::string, std::string, std::string, std::string>> files = {
        {"a.stl", stl_text(given), "STL", "knob"},
        {"a.STL", stl_bytes(given), "STL", "shell1"},
        {"a.obj", obj_text({given}), "OBJ", "knob"},
        {"a.ply", ply_text(given), "PLY", "shell1"},
        {"a.3mf", three_mf_bytes("millimeter", three_mf_object(1, given), "<item objectid=\"1\"/>"), "3MF", "knob"}};
    for (const auto& [name, bytes, format, body] : files) {
        const MeshFile file = read(name, bytes);
        EXPECT_EQ(file.format, format);
        ASSERT_EQ(names_of(file), std::vector<std::string>{body}) << name;
        EXPECT_EQ(file.bodies[0].vertices.size(), 24u) << name;
        EXPECT_EQ(file.bodies[0].triangles.size(), 44u) << name;
        EXPECT_NEAR(signed_volume(file.bodies[0]), signed_volume(given), 1e-4) << name;
        EXPECT_TRUE(file.problems.empty());
        EXPECT_EQ(file.counts.at("triangle").read, 44);
    }
}

TEST(Mesh, ComponentsOf3mfAreNestedPlacedAndNumbered) {
    Mesh bolt = unit_box;
    bolt.name = "bolt";
    const std::string resources = three_mf_object(1, bolt) +
                                  "<object id=\"2\" type=\"model\" name=\"pair\"><components><component objectid=\"1\"/>"
                                  "<component objectid=\"1\" transform=\"0 1 0 -1 0 0 0 0 1 10 0 0\"/></components></object>"
                                  "<object id=\"3\" type=\"model\"><components><component objectid=\"2\" "
                                  "transform=\"2 0 0 0 2 0 0 0 2 0 0 5\"/></components></object>";
    const MeshFile file = read("a.3mf", three_mf_bytes("inch", resources,
                                                       "<item objectid=\"3\"/><item objectid=\"1\" "
                                                       "transform=\"-1 0 0 0 1 0 0 0 1 0 0 -7\"/>"));
    EXPECT_EQ(file.unit, "in");
    ASSERT_EQ(names_of(file), (std::vector<std::string>{"bolt", "bolt#1", "bolt#2"}));
    const std::vector<std::pair<Vec3, Vec3>> boxes = {
        {{0, 0, 5}, {2, 2, 7}}, {{18, 0, 5}, {20, 2, 7}}, {{-1, 0, -7}, {0, 1, -6}}};
    for (std::size_t k = 0; k < 3; ++k) {
        Vec3 low = file.bodies[k].vertices[0], high = low;
        for (const Vec3& v : file.bodies[k].vertices) low = low.cwiseMin(v), high = high.cwiseMax(v);
        EXPECT_EQ(low, boxes[k].first) << k;
        EXPECT_EQ(high, boxes[k].second) << k;
        EXPECT_GT(signed_volume(file.bodies[k]), 0);
    }
    EXPECT_FALSE(has_repair(file, "inside out")) << "a mirrored instance is no fault of the file";
}

/// A tetrahedron of edge 8 mm, twice.
const std::string collada_text =
    "<?xml version=\"1.0\"?><COLLADA xmlns=\"http://www.collada.org/2005/11/COLLADASchema\" version=\"1.4.1\">"
    "<asset><unit name=\"millimeter\" meter=\"0.001\"/><up_axis>Z_UP</up_axis></asset><library_geometries>"
    "<geometry id=\"g\" name=\"g\"><mesh><source id=\"p\"><float_array id=\"pa\" count=\"12\">0 0 0 8 0 0 0 8 0 0 0 8"
    "</float_array><technique_common><accessor source=\"#pa\" count=\"4\" stride=\"3\"><param name=\"X\" type=\"float\"/>"
    "<param name=\"Y\" type=\"float\"/><param name=\"Z\" type=\"float\"/></accessor></technique_common></source>"
    "<vertices id=\"v\"><input semantic=\"POSITION\" source=\"#p\"/></vertices><triangles count=\"4\">"
    "<input semantic=\"VERTEX\" source=\"#v\" offset=\"0\"/><p>0 2 1 0 1 3 1 2 3 0 3 2</p></triangles></mesh></geometry>"
    "</library_geometries><library_visual_scenes><visual_scene id=\"s\"><node id=\"n1\" name=\"wedge\">"
    "<instance_geometry url=\"#g\"/></node><node id=\"n2\" name=\"wedge\"><translate>0 0 100</translate>"
    "<instance_geometry url=\"#g\"/></node></visual_scene></library_visual_scenes>"
    "<scene><instance_visual_scene url=\"#s\"/></scene></COLLADA>";

TEST(Mesh, NodesOfColladaArePlacedAndBroughtToMetres) {
    const MeshFile file = read("a.dae", collada_text);
    EXPECT_EQ(file.unit, "m");
    ASSERT_EQ(names_of(file), (std::vector<std::string>{"wedge", "wedge#1"}));
    EXPECT_NEAR(signed_volume(file.bodies[0]), 512e-9 / 6, 1e-6 * 512e-9 / 6);
    double low = 1;
    for (const Vec3& v : file.bodies[1].vertices) low = std::min(low, v.z());
    EXPECT_NEAR(low, 0.1, 1e-7) << "z stays up";
}

TEST(Mesh, DamagedFilesAreRefusedInOneLine) {
    const Mesh given = prism(regular_polygon({2, 3}, 5, 12), -1, 1, "knob");
    const std::string binary = stl_bytes(given),
                      zip = three_mf_bytes("inch", three_mf_object(1, given), "<item objectid=\"1\"/>");
    EXPECT_NE(refusal("a.stl", "").find("empty"), std::string::npos);
    EXPECT_NE(refusal("a.stl", binary.substr(0, binary.size() / 2)).find("truncated"), std::string::npos);
    EXPECT_NE(refusal("a.3mf", zip.substr(0, zip.size() / 2)).find("damaged"), std::string::npos);
    EXPECT_NE(refusal("a.3mf", three_mf_bytes("inch", three_mf_object(1, given), "")).find("3MF"), std::string::npos);
    EXPECT_NE(refusal("a.obj", "v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").find("not a number"), std::string::npos);
    EXPECT_NE(refusal("a.obj", "v 1e30 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n").find("absurdly"), std::string::npos);
    EXPECT_NE(refusal("a.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n").find("a.obj"), std::string::npos);
    EXPECT_NE(refusal("a.ply", "nothing of the kind").find("no PLY"), std::string::npos);
    EXPECT_NE(refusal("a.gltf", "{").find("no glTF"), std::string::npos);
    EXPECT_THROW(read_mesh_file("/nowhere/a.stl"), InputError);
}

/// Binary, of either byte order.
std::string ply_bytes(const Mesh& mesh, bool is_big) {
    std::string bytes = ply_text(mesh);
    bytes.erase(bytes.find("end_header\n") + 11);
    bytes.replace(bytes.find("ascii"), 5, is_big ? "binary_big_endian" : "binary_little_endian");
    const auto append = [&](auto value) {
        std::string raw;
        append_bytes(raw, value);
        if (is_big) std::reverse(raw.begin(), raw.end());
        bytes += raw;
    };
    for (const Vec3& v : mesh.vertices)
        for (int k = 0; k < 3; ++k) append(static_cast<float>(v[k]));
    for (const auto& t : mesh.triangles) {
        append(static_cast<unsigned char>(3));
        for (int i : t) append(i);
    }
    return bytes;
}

std::string replaced(std::string text, const std::string& from, const std::string& to) {
    return text.replace(text.find(from), from.size(), to);
}

TEST(Mesh, BinaryPlyIsReadInEitherByteOrder) {
    const Mesh given = prism(regular_polygon({2, 3}, 5, 12), -1, 1);
    for (bool is_big : {false, true}) {
        const MeshFile file = read("a.ply", ply_bytes(given, is_big));
        ASSERT_EQ(file.bodies.size(), 1u);
        EXPECT_NEAR(signed_volume(file.bodies[0]), signed_volume(given), 1e-4);
    }
}

/// A refusal, or a mesh with faults that are told.
bool is_noticed(const std::string& name, const std::string& bytes) {
    try {
        return !read(name, bytes).problems.empty();
    } catch (const InputError& error) { return error.problems().size() == 1; }
}

TEST(Mesh, DamageThatAssimpFallsOverIsNoticed) {
    const Mesh given = prism(regular_polygon({2, 3}, 5, 12), -1, 1, "knob");
    const std::string text = ply_text(given);
    for (bool is_big : {false, true}) {
        const std::string bytes = ply_bytes(given, is_big);
        for (std::size_t length = bytes.size() - 1; length > bytes.find("end_header") + 11; length -= 117)
            EXPECT_TRUE(is_noticed("a.ply", bytes.substr(0, length))) << length;
        std::string far = bytes;
        far[far.size() - (is_big ? 2 : 3)] = 7;
        EXPECT_NE(refusal("a.ply", far).find("not there"), std::string::npos);
    }
    for (std::size_t length = text.size() - 2; length > text.find("end_header") + 11; length -= 117)
        EXPECT_TRUE(is_noticed("a.ply", text.substr(0, length))) << length;
    EXPECT_NE(refusal("a.ply", replaced(text, "\n3 0 1 13", "\n3 0 1 24")).find("not there"), std::string::npos);
    EXPECT_NE(refusal("a.ply", replaced(text, "end_header", "???_header")).find("comes to no end"), std::string::npos);
    EXPECT_NE(refusal("a.gltf", text).find("no glTF"), std::string::npos) << "assimp would read it as what it is, in metres";
    for (const auto& [from, to] : std::vector<std::pair<std::string, std::string>>{{" count=\"12\"", ""},
                                                                                   {"\"12\"", "\"13\""},
                                                                                   {" source=\"#v\"", ""},
                                                                                   {" url=\"#g\"", ""},
                                                                                   {"0 0 100", "0 100"},
                                                                                   {"0 2 1", "0 2 -1"},
                                                                                   {"0 2 1", "0 2 9"}})
        EXPECT_TRUE(is_noticed("a.dae", replaced(collada_text, from, to))) << from << to;
}

TEST(Mesh, SpacesBelongToNamesInObj) {
    const Mesh box2 = box({2, 0, 0}, {3, 1, 1}, "left  pad ");
    Mesh box1 = unit_box;
    box1.name = "left jaw #2";
    const MeshFile file = read("a.obj", obj_text({box1, box2}));
    EXPECT_EQ(names_of(file), (std::vector<std::string>{"left jaw #2", "left  pad"}));
    std::string groups = obj_text({box1, box2});
    for (std::size_t at = groups.find("o left"); at != std::string::npos; at = groups.find("o left")) groups[at] = 'g';
    EXPECT_EQ(names_of(read("b.obj", groups)), (std::vector<std::string>{"left jaw #2", "left  pad"}));
}

TEST(Mesh, CoordinatesTooFarAwayForTheirPrecisionAreTold) {
    for (const auto& [away, is_told] :
         {std::pair{0.0, false}, std::pair{100.0, false}, std::pair{1e4, true}, std::pair{1e6, true}}) {
        Mesh far = unit_box;
        for (Vec3& v : far.vertices) v.x() += away;
        EXPECT_EQ(has_repair(read("a.stl", stl_bytes(far)), "far from the origin"), is_told) << away;
    }
}

/// Of each kind of file, so many with five bytes wrong.
void expect_read_or_refused(int n_rounds) {
    const Mesh given = prism(regular_polygon({2, 3}, 5, 12), -1, 1, "knob");
    const std::vector<std::pair<std::string, std::string>> files = {
        {"a.stl", stl_bytes(given)}, {"a.stl", stl_text(given)},         {"a.obj", obj_text({given})},
        {"a.ply", ply_text(given)},  {"a.ply", ply_bytes(given, false)}, {"a.dae", collada_text}};
    std::mt19937 random(2);
    int n_refused = 0;
    for (const auto& [name, whole] : files)
        for (int round = 0; round < n_rounds; ++round) {
            std::string bytes = whole;
            for (int k = 0; k < 5; ++k) bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
            try {
                for (const Mesh& body : read(name, bytes).bodies)
                    for (const Vec3& v : body.vertices) EXPECT_TRUE(v.allFinite());
            } catch (const InputError&) { ++n_refused; }
        }
    EXPECT_GT(n_refused, 0);
    EXPECT_LT(n_refused, static_cast<int>(files.size()) * n_rounds);
}

TEST(Mesh, FilesWithSomeBytesWrongAreReadOrRefused) {
    expect_read_or_refused(5);
}

TEST(LongMesh, FilesWithSomeBytesWrongAreReadOrRefused) {
    expect_read_or_refused(200);
}

TEST(Mesh, EndingsTell) {
    for (const char* name : {"a.stl", "A.STL", "b/c.obj", "x.3mf", "x.3MF", "x.ply", "x.gltf", "x.glb", "x.dae"})
        EXPECT_TRUE(is_mesh_file(name)) << name;
    for (const char* name : {"a.dxf", "stl", "a.stl.txt", "a.step", ""}) EXPECT_FALSE(is_mesh_file(name)) << name;
}

}  // namespace
}  // namespace abut::geometry::mesh_test

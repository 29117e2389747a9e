// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/foreign/record_stream.hpp"

#include <gtest/gtest.h>

#include <cstring>
#include <random>

#include "geometry/brep/input_error.hpp"
#include "geometry/mesh/mesh_records.hpp"
#include "tests/geometry/mesh/small_meshes.hpp"

namespace abut::geometry::record_stream_test {
namespace {

/// A reader of these bytes; what is asked for beyond them is an error, as of a process that has ended.
RecordReader reader_of(const std::string& bytes, std::size_t& at) {
    return {"a.file", [&bytes, &at](char* to, std::size_t n) {
                if (n > bytes.size() - at) throw InputError("a.file", "it ends too early");
                std::memcpy(to, bytes.data() + at, n);
                at += n;
            }};
}

/// Two boxes as a stream.
std::string box_stream() {
    std::string bytes;
    RecordWriter writer([&bytes](std::string_view portion) { bytes += portion; });
    MeshRecords records(writer);
    writer.kind(begin_record);
    records.unit("mm");
    records.object(box({0, 0, 0}, {1, 2, 3}, "base"));
    records.ignore("line", "bounds no body");
    records.object(box({5, 0, 0}, {6, 2, 3}, "lid"));
    writer.kind(end_record);
    writer.flush();
    return bytes;
}

MeshFile file_of(const std::string& bytes) {
    std::size_t at = 0;
    RecordReader reader = reader_of(bytes, at);
    MeshBodies bodies(MeshFile{"a.file", "STL", {}, {}, {}, {}, {}, {}});
    read_mesh_records(reader, bodies);
    return bodies.finish();
}

TEST(RecordStream, ObjectsArriveAsTheyWere) {
    const MeshFile file = file_of(box_stream());
    EXPECT_EQ(file.unit, "mm");
    ASSERT_EQ(file.bodies.size(), 2u);
    EXPECT_EQ(file.bodies[0].name, "base");
    EXPECT_EQ(file.bodies[1].name, "lid");
    EXPECT_EQ(file.bodies[1].vertices.size(), 8u);
    Box3 extent;
    for (const Vec3& v : file.bodies[1].vertices) extent.add(v);
    EXPECT_EQ(extent.low, Vec3(5, 0, 0));
    EXPECT_EQ(extent.high, Vec3(6, 2, 3));
    EXPECT_EQ(file.bodies[1].triangles.size(), 12u);
    ASSERT_EQ(file.ignored.size(), 1u);
    EXPECT_EQ(file.ignored[0].what, "line");
}

TEST(RecordStream, AFailureIsThrownWithItsWords) {
    std::string bytes;
    RecordWriter writer([&bytes](std::string_view portion) { bytes += portion; });
    writer.kind(failure_record);
    writer.text("it is no good");
    writer.text("make a better one");
    writer.flush();
    std::size_t at = 0;
    try {
        reader_of(bytes, at).kind();
        FAIL();
    } catch (const InputError& error) {
        EXPECT_EQ(one_line(error.problems().front()), "a.file: it is no good; make a better one");
    }
}

TEST(RecordStream, StreamsThatEndEarlyOrAreOverwrittenAreRefusedOrRead) {
    const std::string whole = box_stream();
    for (std::size_t n = 0; n < whole.size(); ++n) EXPECT_THROW(file_of(whole.substr(0, n)), InputError) << n;
    std::mt19937 random(3);
    int n_refused = 0;
    for (int round = 0; round < 2000; ++round) {
        std::string bytes = whole;
        bytes[random() % bytes.size()] = static_cast<char>(random() % 256);
        try {
            for (const Mesh& body : file_of(bytes).bodies)
                for (const Vec3& v : body.vertices) EXPECT_TRUE(v.allFinite());
        } catch (const InputError&) { ++n_refused; }
    }
    EXPECT_GT(n_refused, 100);
}

}  // namespace
}  // namespace abut::geometry::record_stream_test

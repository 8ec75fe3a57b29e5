#include "gmsh_texts.hpp"
#include "test_paths.hpp"

#include <floe/mesh/mesh_file.hpp>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace floe::mesh {
namespace {

using test::error_of;
using test::replaced;
using testing::ElementsAre;
using testing::HasSubstr;

// Two squares side by side: 1 in the surface 5, 2 in the surface 6
const std::string kNodes =
    "$Nodes\n1 6 1 6\n2 5 0 6\n1\n2\n3\n4\n5\n6\n0 0 0\n1 0 0\n2 0 0\n0 1 0\n1 1 0\n2 1 "
    "0\n$EndNodes\n";
const std::string kElements =
    "$Elements\n2 2 1 2\n2 5 3 1\n1 1 2 5 4\n2 6 3 1\n2 2 3 6 5\n$EndElements\n";
const std::string kNames =
    "$PhysicalNames\n3\n1 4 \"edge\"\n2 7 \"the deck\"\n2 8 \"all\"\n$EndPhysicalNames\n";
const std::string kEntities =
    "$Entities\n1 1 2 0\n1 0 0 0 0\n1 0 0 0 2 0 0 1 4 2 1 1\n5 0 0 0 1 1 0 2 -7 8 1 1\n6 1 0 0 2 1 "
    "0 1 8 0\n$EndEntities\n";
const std::string kHead = "$MeshFormat\n4.1 0 8\n$EndMeshFormat\n";

TEST(GmshGroups, AreThePhysicalSurfacesOfMsh41ByNameOrNumber) {
  const MeshFile named = read_mesh_bytes(kHead + kNames + kEntities + kNodes + kElements, "a.msh");
  ASSERT_EQ(named.groups.size(), 2u);
  EXPECT_EQ(named.groups[0].name, "the deck");
  EXPECT_THAT(named.groups[0].elements, ElementsAre(0));
  EXPECT_EQ(named.groups[1].name, "all");
  EXPECT_THAT(named.groups[1].elements, ElementsAre(0, 1));
  const MeshFile numbered = read_mesh_bytes(kHead + kEntities + kNodes + kElements, "a.msh");
  ASSERT_EQ(numbered.groups.size(), 2u);
  EXPECT_EQ(numbered.groups[0].name, "7");
  EXPECT_TRUE(read_mesh_bytes(kHead + kNodes + kElements, "a.msh").groups.empty());
}

TEST(GmshGroups, AreTheFirstTagsOfMsh22) {
  const std::string text =
      "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n" + kNames +
      "$Nodes\n6\n1 0 0 0\n2 1 0 0\n3 2 0 0\n4 0 1 0\n5 1 1 0\n6 2 1 0\n$EndNodes\n"
      "$Elements\n2\n1 3 2 7 1 1 2 5 4\n2 3 2 0 1 2 3 6 5\n$EndElements\n";
  const MeshFile file = read_mesh_bytes(text, "a.msh");
  ASSERT_EQ(file.groups.size(), 1u);
  EXPECT_EQ(file.groups[0].name, "the deck");
  EXPECT_THAT(file.groups[0].elements, ElementsAre(0));
}

// Gmsh's own file of one physical surface
TEST(GmshGroups, AreReadFromTheFilesOfGmsh) {
  const std::filesystem::path meshes = std::filesystem::path(FLOE_SOURCE_DIR) / "meshes";
  for (const char* name : {"disc.msh", "lshape.msh", "plate_with_hole.msh", "ring.msh"}) {
    const MeshFile file = read_mesh(meshes / name);
    ASSERT_EQ(file.groups.size(), 1u) << name;
    EXPECT_EQ(file.groups[0].name, "plate");
    EXPECT_EQ(std::ssize(file.groups[0].elements), file.mesh.element_count());
  }
}

TEST(GmshGroups, RefusesDamagedNamesAndEntities) {
  const std::string text = kHead + kNames + kEntities + kNodes + kElements;
  EXPECT_THAT(error_of(replaced(text, "\"the deck\"", "deck")),
              HasSubstr("a.msh:7: invalid name of a physical group (must stand in double quotes)"));
  EXPECT_THAT(error_of(replaced(text, "deck\"", "deck")),
              HasSubstr("must end with a double quote"));
  EXPECT_THAT(error_of(replaced(text, "$PhysicalNames\n3", "$PhysicalNames\n999999999")),
              HasSubstr("invalid count of physical names = 999999999"));
  EXPECT_THAT(error_of(replaced(text, "1 1 2 0\n1 0", "1 1 99999999 0\n1 0")),
              HasSubstr("invalid entity count = 99999999"));
  EXPECT_THAT(error_of(replaced(text, "1 1 0 2 -7", "1 1 0 99999 -7")),
              HasSubstr("invalid physical groups of an entity = 99999"));
}

}  // namespace
}  // namespace floe::mesh

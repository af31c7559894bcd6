#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <numbers>

#include "engine/contact/body_form.h"
#include "equipment/catalogue/check_file.h"
#include "equipment/catalogue/load_item.h"
#include "equipment/catalogue/mesh_file.h"
#include "tests/support/error_text.h"
#include "tests/support/temp_folder.h"

// Shapes of items, parts and contents besides boxes, and meshes.
namespace gurney::equipment {
namespace {

using testing::AllOf;
using testing::HasSubstr;

constexpr const char* kHead = R"(schema = "gurney-item/1"
name = "table"
[chassis]
mass_kg = 20
center_of_mass_mm = [0, 0, 350]
inertia_box_mm = [600, 400, 700]
[contact]
material = "steel"
friction = 0.4
restitution = 0.2
)";
constexpr const char* kTop = R"([[shape]]
center_mm = [0, 0, 350]
size_mm = [600, 400, 700]
)";

std::string content(const std::string& name, const std::string& place, const std::string& keys) {
  return "[[content]]\nname = \"" + name + "\"\nposition_mm = " + place + "\nmass_kg = 2\n" + keys +
         "[content.contact]\nmaterial = \"" + name + "\"\nfriction = 0.3\nrestitution = 0.2\n";
}

class ShapesFile : public testing::Test {
 protected:
  LoadedItem load(const std::string& text) {
    return load_item(folder_.write("item.toml", kHead + text));
  }
  /// What is wrong, after the name of the file.
  std::string error(const std::string& text) {
    const std::string file = folder_.write("item.toml", kHead + text);
    const std::string all = error_text([&] { check_data_file(file); });
    EXPECT_EQ(all.rfind(file + ":", 0), 0u) << all;
    return all.substr(std::min(all.size(), file.size() + 1));
  }
  TempFolder folder_;
};

TEST_F(ShapesFile, AreCylindersSpheresAndHulls) {
  const LoadedItem item = load(R"([[shape]]
kind = "cylinder"
axis = [2, 0, 0]
center_mm = [0, 0, 50]
radius_mm = 50
length_mm = 300
[[shape]]
kind = "sphere"
center_mm = [0, 0, 400]
radius_mm = 100
[[shape]]
kind = "hull"
position_mm = [0, 0, 500]
points_mm = [[0, 0, 0], [200, 0, 0], [0, 300, 0], [0, 0, 400], [50, 50, 50]]
)");
  ASSERT_EQ(item.model.shape.size(), 3u);
  const auto& cylinder = std::get<SolidCylinder>(item.model.shape[0].solid);
  EXPECT_EQ(cylinder.axis, Vector3::UnitX());
  EXPECT_LT((item.model.shape[0].size - Vector3(0.3, 0.1, 0.1)).norm(), 1e-15);
  EXPECT_EQ(std::get<SolidSphere>(item.model.shape[1].solid).radius, 0.1);
  const BodyShape& hull = item.model.shape[2];
  EXPECT_EQ(std::get<SolidHull>(hull.solid).corners.size(), 4u) << "one of five lies within";
  EXPECT_LT((hull.center - Vector3(0.1, 0.15, 0.7)).norm(), 1e-12);
  EXPECT_NEAR(volume_of(hull), 0.2 * 0.3 * 0.4 / 6, 1e-15);
}

TEST_F(ShapesFile, OfContentsStandOnTheirUnderside) {
  const LoadedItem item = load(
      kTop +
      content("bottle", "[100, 0, 700]", "kind = \"cylinder\"\nradius_mm = 40\nlength_mm = 300\n") +
      content("ball", "[-100, 0, 700]", "kind = \"sphere\"\nradius_mm = 60\n") +
      content("wedge", "[0, 100, 700]",
              "kind = \"hull\"\npoints_mm = "
              "[[0,0,10],[60,0,10],[0,60,10],[60,60,10],[0,0,70],[0,60,70]]\n"));
  ASSERT_EQ(item.contents.size(), 3u);
  const EquipmentModel& bottle = item.contents[0].model;
  EXPECT_NEAR(bottle.chassis_center_of_mass.z(), 0.15, 1e-15);
  EXPECT_NEAR(bottle.chassis_inertia(2, 2), 2 * 0.04 * 0.04 / 2, 1e-15);
  EXPECT_NEAR(item.contents[1].model.chassis_inertia(0, 0), 0.4 * 2 * 0.06 * 0.06, 1e-15);
  const EquipmentModel& wedge = item.contents[2].model;
  EXPECT_NEAR(wedge.shape[0].bottom(), 0, 1e-15);
  // The triangle (0, 0), (60, 0), (0, 60) has its centroid a third from the right angle; the middle is at 30.
  EXPECT_LT((wedge.chassis_center_of_mass - Vector3(-0.01, 0, 0.02)).norm(), 1e-12);
}

TEST_F(ShapesFile, SayWhatIsWrongAndWhere) {
  EXPECT_THAT(error("[[shape]]\nkind = \"cilinder\"\n"),
              AllOf(HasSubstr("12:8: shape[0].kind = \"cilinder\""), HasSubstr("cylinder")));
  EXPECT_THAT(error("[[shape]]\nkind = \"sphere\"\ncenter_mm = [0, 0, 50]\nradius_mm = 0\n"),
              HasSubstr("14:13: shape[0].radius_mm = 0: must be a finite number > 0"));
  EXPECT_THAT(error("[[shape]]\nkind = \"sphere\"\ncenter_mm = [0, 0, 50]\nradius_mm = 50\nsize_mm "
                    "= [1, 1, 1]\n"),
              HasSubstr("size_mm: unknown key"));
  const std::string flat =
      "[[shape]]\nkind = \"hull\"\npoints_mm = [[0,0,0],[100,0,0],[0,100,0],[100,100,0]]\n";
  EXPECT_THAT(error(flat), HasSubstr("13:13: shape[0].points_mm: the points span no volume"));
  EXPECT_THAT(error("[[shape]]\nkind = \"hull\"\npoints_mm = [[0,0,0],[1,2]]\n"),
              HasSubstr("points_mm = "));
  std::string many = "[[shape]]\nkind = \"hull\"\npoints_mm = [";
  for (int i = 0; i < 70; ++i) {
    const double z = -1 + 2 * (i + 0.5) / 70, r = std::sqrt(1 - z * z), a = 2.399963 * i;
    many += "[" + std::to_string(100 * r * std::cos(a)) + "," +
            std::to_string(100 * r * std::sin(a)) + "," + std::to_string(100 * z) + "],";
  }
  EXPECT_THAT(error(many + "]\n"), HasSubstr("its hull has 70 corners: must be at most 64"));
}

TEST_F(ShapesFile, OfContentsNeitherFloatNorOverlap) {
  EXPECT_THAT(
      error(kTop + content("ball", "[0, 0, 720]", "kind = \"sphere\"\nradius_mm = 60\n")),
      AllOf(HasSubstr(
          "16:15: content 'ball': no shape of the chassis has a level top below it at 720 mm")));
  const std::string rail = "[[shape]]\ncenter_mm = [200, 0, 750]\nsize_mm = [20, 400, 100]\n";
  EXPECT_THAT(error(kTop + rail + content("box", "[150, 0, 700]", "size_mm = [100, 100, 100]\n")),
              HasSubstr("content 'box' stands 10 mm deep in the chassis"));
  EXPECT_THAT(error(kTop +
                    content("one", "[0, 0, 700]",
                            "kind = \"cylinder\"\nradius_mm = 40\nlength_mm = 100\n") +
                    content("other", "[70, 0, 700]", "kind = \"sphere\"\nradius_mm = 40\n")),
              HasSubstr("content 'other' stands 10 mm deep in content 'one'"));
}

TEST_F(ShapesFile, OfPartsAndContentsHaveNamesThatResultsCanTell) {
  const auto part = [](const std::string& name) {
    return "[[part]]\nname = \"" + name + "\"\njoint = \"fixed\"\nmass_kg = 1\n" +
           "center_of_mass_mm = [0, 0, 800]\ninertia_box_mm = [10, 10, 10]\n" +
           "position_mm = [0, 0, 700]\n";
  };
  for (const char* bad : {"", "chassis", "a/b", "a\\nb"})
    EXPECT_THAT(error(kTop + part(bad)),
                HasSubstr("part[0].name: must not be empty or \"chassis\", or have a '/'"))
        << bad;
  const std::string box = content("arm", "[0, 0, 700]", "size_mm = [50, 50, 50]\n");
  EXPECT_THAT(error(kTop + part("arm") + box),
              HasSubstr("content[0].name = \"arm\": must differ from the names of parts"));
  std::string spun = part("arm");
  const std::string stated = "inertia_box_mm = [10, 10, 10]";
  spun.replace(spun.find(stated), stated.size(),
               "inertia_kg_m2 = [0.1, 0.1, 0.1]\ninertia_products_kg_m2 = [0.2, 0, 0]");
  EXPECT_THAT(error(kTop + spun),
              HasSubstr("19:17: part[0].inertia_kg_m2 with principal moments -0.09"));
}

const Vector3 kCorners[] = {{0, 0, 0}, {200, 0, 0}, {0, 100, 0}, {0, 0, 300}};
constexpr int kTriangles[][3] = {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}};

std::string numbers(const Vector3& v) {
  return std::to_string(v.x()) + " " + std::to_string(v.y()) + " " + std::to_string(v.z());
}

std::string ascii_stl() {
  std::string text = "solid tetrahedron\n";
  for (const auto& triangle : kTriangles) {
    text += "facet normal 0 0 1\nouter loop\n";
    for (int i : triangle) text += "  vertex " + numbers(kCorners[i]) + "\r\n";
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid tetrahedron\n";
}

std::string binary_stl() {
  std::string bytes("solid made by a program that writes binary files all the same");
  bytes.resize(80, ' ');
  const auto add = [&](const auto& value) {
    const auto* at = reinterpret_cast<const char*>(&value);
    bytes.append(at, sizeof(value));
  };
  add(std::uint32_t{4});
  for (const auto& triangle : kTriangles) {
    for (int k = 0; k < 3; ++k) add(0.0f);
    for (int i : triangle)
      for (int k = 0; k < 3; ++k) add(static_cast<float>(kCorners[i][k]));
    add(std::uint16_t{0});
  }
  return bytes;
}

std::string obj(const std::string& before_faces) {
  std::string text = "# a mesh\n";
  for (const Vector3& corner : kCorners) text += "v " + numbers(corner) + "\n";
  text += before_faces;
  for (const auto& triangle : kTriangles)
    text += "f " + std::to_string(triangle[0] + 1) + "/1/1 " + std::to_string(triangle[1] - 4) +
            " " + std::to_string(triangle[2] + 1) + "//1\n";
  return text;
}

TEST_F(ShapesFile, AreTheSameHullOfEveryFormatOfAMesh) {
  folder_.write("ascii.stl", ascii_stl());
  folder_.write("binary.STL", binary_stl());
  folder_.write("mesh.obj", obj("o tetrahedron\n"));
  const auto read = [&](const std::string& file) {
    const LoadedItem item = load("[[shape]]\nkind = \"mesh\"\nfile = \"" + file +
                                 "\"\nunit = \"mm\"\nposition_mm = [10, 0, 0]\n");
    EXPECT_EQ(item.model.shape.size(), 1u);
    return outline_points(item.model.shape.at(0));
  };
  const std::vector<Vector3> hull = read("mesh.obj");
  EXPECT_EQ(hull.size(), 4u);
  for (const Vector3& corner : kCorners)
    EXPECT_TRUE(std::ranges::any_of(hull, [&](const Vector3& point) {
      return (point - (corner + Vector3(10, 0, 0)) / 1000).norm() < 1e-12;
    }));
  for (const char* other : {"ascii.stl", "binary.STL"}) {
    const std::vector<Vector3> same = read(other);
    for (const Vector3& corner : hull)
      EXPECT_TRUE(std::ranges::any_of(same, [&](const Vector3& point) {
        return (point - corner).norm() < 1e-12;
      })) << other;
  }
}

// A grid over a ball: 20,000 points of which the hull keeps too many; and over a box, of which it keeps 8.
TEST_F(ShapesFile, OfMeshesAreOneHullOfEachObject) {
  std::string text = obj("o first\n");
  text +=
      "v 500 0 0\nv 700 0 0\nv 500 100 0\nv 500 0 300\ng second\nf 5 7 6\nf 5 6 8\nf 6 7 8\nf 5 8 "
      "7\n";
  folder_.write("two.obj", text);
  const std::string shape = "[[shape]]\nkind = \"mesh\"\nunit = \"mm\"\nfile = ";
  const LoadedItem item = load(shape + "\"two.obj\"\n");
  ASSERT_EQ(item.model.shape.size(), 2u);
  EXPECT_NEAR(volume_of(item.model.shape[0]), volume_of(item.model.shape[1]), 1e-15);
  std::string grid, faces;
  int count = 0;
  for (int i = 0; i <= 30; ++i)
    for (int j = 0; j <= 30; ++j)
      for (const double z : {0.0, 200.0}) {
        grid += "v " + numbers({10.0 * i, 10.0 * j, z}) + "\n";
        faces += "f " + std::to_string(++count) + "\n";
      }
  folder_.write("grid.obj", grid + faces);
  const LoadedItem box = load(shape + "\"grid.obj\"\n");
  EXPECT_EQ(outline_points(box.model.shape.at(0)).size(), 8u);
  EXPECT_NEAR(volume_of(box.model.shape[0]), 0.3 * 0.3 * 0.2, 1e-12);
}

TEST_F(ShapesFile, OfMeshesSayWhatIsWrong) {
  const std::string shape = "[[shape]]\nkind = \"mesh\"\nunit = \"m\"\nfile = ";
  EXPECT_THAT(error(shape + "\"none.stl\"\n"),
              AllOf(HasSubstr("14:8: shape[0].file = \"none.stl\": no such file: "),
                    HasSubstr("none.stl")));
  folder_.write("mesh.obj", obj(""));
  EXPECT_THAT(error(shape + "\"mesh.obj\"\n"),
              HasSubstr("the mesh is 300 m long in unit = \"m\": must be 0.001 to 20 m"));
  EXPECT_THAT(error(shape + "\"mesh.ply\"\n"), HasSubstr("must be a mesh *.stl or *.obj"));
  folder_.write("bad.obj", "v 0 0 0\nv 1 0\n");
  EXPECT_THAT(error(shape + "\"bad.obj\"\n"),
              HasSubstr("bad.obj:2: \"1 0\": must be three numbers"));
  folder_.write("far.obj", "v 0 0 0\nf 1 2 3\n");
  EXPECT_THAT(error(shape + "\"far.obj\"\n"),
              HasSubstr("far.obj:2: \"2\": must be a vertex, 1 to 1"));
  folder_.write("short.stl", binary_stl().substr(0, 200));
  EXPECT_THAT(error(shape + "\"short.stl\"\n"), HasSubstr("has no triangles"));
  folder_.write("other.stl", "PK");
  EXPECT_THAT(error(shape + "\"other.stl\"\n"), HasSubstr("neither an ASCII STL"));
}

}  // namespace
}  // namespace gurney::equipment

#include "coupling/exchange/effects.h"

#include <gtest/gtest.h>

#include <iterator>
#include <sstream>

#include "coupling/base/error.h"

namespace gasgrain {
namespace {

std::string faults_of(const std::vector<std::string>& words) {
  try {
    parse_effects(words, "in.liggghts:12");
  } catch (const Error& e) {
    return e.what();
  }
  return "";
}

TEST(effects, are_read_from_the_words_of_a_line) {
  const Effects effects =
      parse_effects({"drag", "koch_hill", "void_fraction", "offset", "pressure_gradient"}, "test");
  EXPECT_EQ(effects.text(), "void_fraction offset drag koch_hill pressure_gradient");
  EXPECT_TRUE(effects.lent().has(GasField::velocity));
  EXPECT_TRUE(effects.lent().has(GasField::void_fraction));
  EXPECT_TRUE(effects.lent().has(GasField::pressure_gradient));
  EXPECT_TRUE(effects.taken().has(GasField::drag_source));
}

TEST(effects, read_their_own_text) {
  for (const auto& drag : choice_names<DragModel>())
    for (const auto& method : method_names()) {
      const Effects effects = parse_effects({"drag", drag, "void_fraction", method}, "test");
      const std::string text = effects.text();
      EXPECT_EQ(text.find("void_fraction " + method), 0U) << text;
      EXPECT_NE(text.find(" drag " + drag), std::string::npos) << text;
      std::istringstream stream(text);
      const std::vector<std::string> words{std::istream_iterator<std::string>(stream), {}};
      EXPECT_EQ(parse_effects(words, "test").text(), text);
    }
}

TEST(effects, read_the_width_of_a_kernel_and_the_size_of_a_particle_grid) {
  const auto width = [](const Effects& e) { return std::get<VoidFractionKernel>(e.method).width; };
  EXPECT_EQ(width(parse_effects({"void_fraction", "kernel", "3.5", "drag", "tang"}, "test")), 3.5);
  EXPECT_EQ(width(parse_effects({"void_fraction", "kernel", "drag", "tang"}, "test")),
            VoidFractionKernel::default_width);
  EXPECT_EQ(parse_effects({"void_fraction", "particle_grid", "3"}, "test").text(),
            "void_fraction particle_grid 3");
  for (const std::string word : {"0.1", "100", "3mm", "-2"})
    EXPECT_EQ(faults_of({"void_fraction", "kernel", word, "drag", "tang"}),
              "in.liggghts:12: void_fraction kernel " + word +
                  ": the width must be a number of particle diameters from 0.5 to 20. Leave it out "
                  "for 2.");
  EXPECT_NE(faults_of({"void_fraction", "offset", "3"}).find("\"3\" is unknown"),
            std::string::npos);
}

TEST(effects, that_are_absent_ask_for_no_fields) {
  const Effects none = parse_effects({}, "test");
  EXPECT_EQ(none.text(), "void_fraction auto");
  EXPECT_TRUE(none.choose_method);
  EXPECT_EQ(none.lent().bits(), 0U);
  EXPECT_EQ(none.taken().bits(), FieldSet().add(GasField::solid_volume).bits());
  const Effects drag = parse_effects({"drag", "di_felice"}, "test");
  EXPECT_FALSE(drag.lent().has(GasField::pressure_gradient));
  const Effects pressure = parse_effects({"pressure_gradient"}, "test");
  EXPECT_EQ(pressure.lent().bits(), FieldSet().add(GasField::pressure_gradient).bits());
  EXPECT_FALSE(pressure.taken().has(GasField::drag_coefficient));
}

TEST(effects, with_faults_are_refused_with_all_of_them_and_the_nearest_names) {
  const std::string text =
      faults_of({"drag", "koch_hil", "void_fraction", "ofset", "presure_gradient"});
  EXPECT_EQ(text,
            "in.liggghts:12: drag \"koch_hil\" is unknown. Did you mean \"koch_hill\"?\n"
            "in.liggghts:12: void_fraction \"ofset\" is unknown. Did you mean \"offset\"?\n"
            "in.liggghts:12: the effect \"presure_gradient\" is unknown. Did you mean "
            "\"pressure_gradient\"?");
}

TEST(effects, without_the_name_they_need_say_which_there_are) {
  EXPECT_EQ(faults_of({"drag", "pressure_gradient"}),
            "in.liggghts:12: \"drag\" must be followed by one of: ergun_wen_yu, koch_hill, "
            "di_felice, gidaspow, gidaspow_blend, hill_koch_ladd, beetstra, tenneti, tang, "
            "schiller_naumann.");
  EXPECT_NE(faults_of({"void_fraction"}).find("centre, offset, trilinear"), std::string::npos);
}

TEST(effects, take_the_parameters_of_a_force_in_any_order) {
  const Effects effects = parse_effects(
      {"lorentz", "magnetic", "0", "0", "1e-3", "charge", "2e-9", "drag", "tang"}, "test");
  const auto& lorentz = std::get<ForceLorentz>(effects.forces.front());
  EXPECT_EQ(lorentz.charge, 2e-9);
  EXPECT_EQ(lorentz.magnetic, Vec3(0, 0, 1e-3));
  EXPECT_EQ(lorentz.electric, Vec3::Zero());
  EXPECT_TRUE(effects.drag);
  EXPECT_EQ(faults_of({"lorentz", "electric", "1", "2", "drag", "tang"}),
            "in.liggghts:12: lorentz electric must be followed by 3 number(s) in V/m, found "
            "\"drag\".");
  EXPECT_NE(faults_of({"basset", "tolerance", "0.5"}).find("from 0.0001 to 0.2, found \"0.5\""),
            std::string::npos);
  const Effects all = parse_effects({"basset", "tolerance", "0.1", "horizon", "1000"}, "test");
  EXPECT_EQ(all.text(), "void_fraction auto basset tolerance 0.1 horizon 1000");
  EXPECT_EQ(all.layout(false).size, RecordLayout().size + 3 + 3 * 4);  // Du/Dt and four series
}

TEST(effects, that_change_drag_want_one) {
  for (const std::string word : {"polydisperse", "momentum_sharing", "self_disturbance"}) {
    std::vector<std::string> words{word};
    if (word == "momentum_sharing") words.push_back("scheme_2");
    if (word == "self_disturbance") words.push_back("ignored");
    EXPECT_EQ(faults_of(words), "in.liggghts:12: \"" + word +
                                    "\" changes drag, and there is none. Add \"drag NAME\", or "
                                    "remove it.");
    words.insert(words.end(), {"drag", "tang"});
    const Effects effects = parse_effects(words, "test");
    EXPECT_NE(effects.text().find(word), std::string::npos) << effects.text();
  }
}

TEST(effects, ask_for_the_fields_and_the_room_of_their_own_only) {
  const int bare = parse_effects({"drag", "tang"}, "test").layout(false).size;
  EXPECT_EQ(bare, RecordLayout().size);
  const auto size = [](const std::vector<std::string>& words, bool overlapped = false) {
    return parse_effects(words, "test").layout(overlapped).size;
  };
  EXPECT_EQ(size({"drag", "tang", "pressure_gradient"}), bare);
  EXPECT_EQ(size({"drag", "tang", "viscous_stress"}), bare + 3);
  EXPECT_EQ(size({"drag", "tang", "saffman_mei", "magnus"}), bare + 3);
  EXPECT_EQ(size({"drag", "tang", "virtual_mass"}), bare + 3);
  EXPECT_EQ(size({"drag", "tang"}, true), bare + 6);
  EXPECT_EQ(parse_effects({"saffman_mei"}, "test").taken().bits(),
            FieldSet().add(GasField::solid_volume).add(GasField::drag_source).bits());
}

TEST(effects, named_twice_are_refused) {
  EXPECT_EQ(faults_of({"drag", "koch_hill", "drag", "di_felice"}),
            "in.liggghts:12: \"drag\" is named twice. Remove one of them.");
  EXPECT_NE(faults_of({"pressure_gradient", "pressure_gradient"}).find("twice"), std::string::npos);
}

}  // namespace
}  // namespace gasgrain

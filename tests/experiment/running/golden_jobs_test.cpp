#include "tests/experiment/running/jobs.hpp"

#include <gtest/gtest.h>
#include <string>
#include <string_view>

// Digests of whole jobs. They are the same for every compiler, optimisation and processor. A change that alters one
// alters outcomes that are stored somewhere: raise experiment::science_version with it.

namespace lamprey::experiment {
namespace {

struct GoldenJob {
  std::string_view choices;  ///< mutation, steps, acceptance, criterion, posture
  std::string_view digest;
};

constexpr GoldenJob golden_jobs[] = {
    {"all uniform simple per_component reset", "a937145323e803521701eb9528d09dc8fde7d8ee76285947ba8b2aeb22807ab4"},
    {"all uniform simple per_component carry", "10369b27656ee045cca918c83e54f65df10317d3a8a0b743d03790696639a60b"},
    {"all uniform simple total reset", "172ee998db894a05b7d70f34514f3e98fc9f3850613d0e885b266294025facca"},
    {"all uniform simple total carry", "0a33d280c566cd78fe0566d0f7d16e4098b2a9fd9b805cc504477745e76c4826"},
    {"all uniform annealing per_component reset", "b26cda86b141b4121f3a874b53f64f510eb10af8e6debc03f358182e12fea768"},
    {"all uniform annealing per_component carry", "8e1c1cc1c9777f2906d4adc08b52b54270ef581b458eba89afc93fadc460ac15"},
    {"all uniform annealing total reset", "b263a95bb93c488d36475f2b5ebbf6747c13b187cde662ada440c3bc3addfc58"},
    {"all uniform annealing total carry", "e0acf70e3d94a1aac7144bdf65064f2ec93f3c75f5d42afffb7f6b6b5cf7dbf0"},
    {"all normal simple per_component reset", "e32c18603948dcddcf869a2b6c07b8b91239df11129e0859f8a9d2b20c79de06"},
    {"all normal simple per_component carry", "0debf7fd1518906e03e6221664986e1c3aa912afa5bb2266d51fb3a1844a3a1e"},
    {"all normal simple total reset", "16c3040885308cfa975a1bb8530b512e918c91bfc2fb194eedf6ae16b65bdb24"},
    {"all normal simple total carry", "d64c1bae8453349891d5787291bc6438c1ec9fa96d15b2b1df2c1ce611f5a0c5"},
    {"all normal annealing per_component reset", "1040494279312bbdb440cb741d575be27898b8fb0d804c1d6161d8bd1f6da40e"},
    {"all normal annealing per_component carry", "d84e790bd08c75f8385bd85493f6cd386a38aa1b70dd70abafc0b3c4972a97f4"},
    {"all normal annealing total reset", "61682ed2f3171df905d65c888da49b46af9563b4062418467f14e58f95562b64"},
    {"all normal annealing total carry", "62af2644cc79469f0a60efdd8048849a7ee517474e9f59f16430a876ad8bac4f"},
    {"all one_fifth_rule simple per_component reset",
     "8472c08ede1d0a1e4cd54622247b0a7d2e1bd60846db70049e370bf821f5d867"},
    {"all one_fifth_rule simple per_component carry",
     "d53fde679b403140bfef8d6a7f61fad5b27a23dd3d7c43aa68c248fac19e4ee8"},
    {"all one_fifth_rule simple total reset", "03ae3afe53ef09cf2133c001ce26249f4fce4782b4174c6686b32620aa2ebe7d"},
    {"all one_fifth_rule simple total carry", "4c4ad125cc31879e1c46871a260b15873ca25d1d13612dc909ec1020a92278c1"},
    {"all one_fifth_rule annealing per_component reset",
     "dfc12fcaeb455b637d4bcdc899ba2c92d776bae296098e79c01201bc5098826d"},
    {"all one_fifth_rule annealing per_component carry",
     "8d8876d66f8dbf73853bd140cd853616e8fbb9eea6a72f796518ecb7735211e5"},
    {"all one_fifth_rule annealing total reset", "6031cd4d2769cfe38ec691bdecc6f25cbdfeda837bb1b0c2615f057f5ab1048c"},
    {"all one_fifth_rule annealing total carry", "3551ef699ab0cdcce0be9566bf3bff42021db7695d97d7a558d38b90089b51b2"},
    {"one uniform simple per_component reset", "c93220db5d6452924d5f3204cf9be6b5cb3c7ce21a8a4d570c760e087bab5bb5"},
    {"one uniform simple per_component carry", "b07d3d1cff9cf5d1e7bc27bd2cfdc82e99902cb5221a4e4b516ad999cc8716a1"},
    {"one uniform simple total reset", "af858da0e097d5673f7f625f1a474142155b9abdd4e202873b3120f9dde36698"},
    {"one uniform simple total carry", "db13e23ea3a83cb2a456027d28807d1a2545e7d323c42f832d678b8016cda3ec"},
    {"one uniform annealing per_component reset", "3ade9d857e677412883e39d457306773a27062b019747720ed7329b07a242010"},
    {"one uniform annealing per_component carry", "06c844a821a5b50ff7837218b4d4a45d6de19faf64824e6b0bfb2073ef595169"},
    {"one uniform annealing total reset", "2d22d21aec02eb5ad492e183cd525500891d4adf6cdcd57c2d9932d4db0ff000"},
    {"one uniform annealing total carry", "9825dc03f805fe23e3ce627b8d361110337300ebb928a5824389db12665dc976"},
    {"one normal simple per_component reset", "4893e2f6b9791db98fb7cbb0f4a9de60e4fd14f73d075b340c7ecf82b7651b5b"},
    {"one normal simple per_component carry", "19821b7bd8ce4041a6cc6854caa4090fa2172b356f7341404620fb6a4bdbc4be"},
    {"one normal simple total reset", "570dae9771cd4a217cf96c149ad5f259ef2abb0998578cc1cde384c25af4aaaa"},
    {"one normal simple total carry", "07baaaaf940a99f01b943117c1320e4e9e1e8950824cd88c3c1e1f10e79a79c1"},
    {"one normal annealing per_component reset", "de1cedb1590cdcbca418f8473e3db687518c95f4c3d827595aaae6738ab93aa9"},
    {"one normal annealing per_component carry", "c74b59e478837309dee14b0bc596db90f234b36b8feb3cffaf9c9df41cb01a29"},
    {"one normal annealing total reset", "f9d5d91c84c7a12c25f3e5ace09745bd343f6d1b56fb1f990a3b31325f61ed50"},
    {"one normal annealing total carry", "06a6987d644f7663e7c7c9e0506180956f548d9b9663a84a92335451d50171d9"},
    {"one one_fifth_rule simple per_component reset",
     "c38e3900d28a1357b912c778566f77c22160128cb0084abaaa2d018f146d6dc5"},
    {"one one_fifth_rule simple per_component carry",
     "4736622eabe815b7da8823f8946d64692c2a204bf120ffcbf18472ff03f46f75"},
    {"one one_fifth_rule simple total reset", "308a442933fc494cf7ffd7bfcbe4ab17659bb593864afdf3ba109487f1610cd9"},
    {"one one_fifth_rule simple total carry", "999d78cc08bf5ba1d088cdbe62d73c5c5d46f0a71e97204645890bb689c563eb"},
    {"one one_fifth_rule annealing per_component reset",
     "eb03aae3b9f8d1a64d4c04a0aab33c2630503cf3a62fba2b44f44779d759617e"},
    {"one one_fifth_rule annealing per_component carry",
     "d39b8c044bd85eaadfd20725785f12996de4fc6497b70dc011431b522915e273"},
    {"one one_fifth_rule annealing total reset", "a9c6d3940a420ec50070f64b552e0731185ae7c9beb1987756275d423822b7ab"},
    {"one one_fifth_rule annealing total carry", "c3e6fe1da833f287d1f4a3f173aa0e6cc8ac31cce38671543b46320bb3492b86"},
    {"some uniform simple per_component reset", "a86e5d8e09cf77a91a876723b901cba8bee1901979a75e3d8785761d911a6d85"},
    {"some uniform simple per_component carry", "438fb23deb096085d53c0aaead096b9a5e7aaf02d68c64eb8533e3cacfbb1ecc"},
    {"some uniform simple total reset", "62534a4c2fabc7ea06405a6e39972312c14b171f9a6e9d04f3e1bb778d9008d6"},
    {"some uniform simple total carry", "690637b715a0c54efe47c25065f018b2b3ad012ef8f7032aed84b8e52be0fb8a"},
    {"some uniform annealing per_component reset", "9b0044f76f7c4ef3aea3b355475229923d8cfe1f5609abd7fdff4259d40c0106"},
    {"some uniform annealing per_component carry", "83b7861ccc28cb46ac9077cc7496256b446f8fa0548724c9387157ce4dd15549"},
    {"some uniform annealing total reset", "c561acf180e6e19bf111cdd98c1a5e3a31ccaf1026b2385e003bf1e6f4b33a05"},
    {"some uniform annealing total carry", "f36d1c8aaa28ff5507ef8263fd14b719f1990e0b140eb0bcf9c94b8f2e6319cb"},
    {"some normal simple per_component reset", "3190410cda37824ccaf53e55e17c413d226f447d9525491da4e8fca41afff529"},
    {"some normal simple per_component carry", "ce22a2eddf9487e8da16cae7e0919d49a172f429103562317367d877646c7436"},
    {"some normal simple total reset", "ef2ded6f8d532d26d3b3484b89e2f973593f337f2ad0f86fd86ef27e708b6fa2"},
    {"some normal simple total carry", "321187abadbb45e09274ec89f1b5428ebdd975168e82be785ec199dfd0d2cd85"},
    {"some normal annealing per_component reset", "cfb2e8d4e03dfdf7765b3afcef4b04cdbab76f6ccbfbc9abfd29022304185c51"},
    {"some normal annealing per_component carry", "cf6e8235722927759e8002305f6a7ddf29501940bc57daca383c19062f1b45f8"},
    {"some normal annealing total reset", "95d5328b1907c7d5cca78ba2236fd949e20a6643457a2758dc78729470a48701"},
    {"some normal annealing total carry", "c4a67d39aa8d34e786ea3f796faed11637b719e513a41903b61959ef84472947"},
    {"some one_fifth_rule simple per_component reset",
     "f90ff66581382602c7d7d12b0a4b8b310481988f2fe75b79bf1ac270179222d7"},
    {"some one_fifth_rule simple per_component carry",
     "559a8438a5e53ef8a3bf3e0724fde7cbfd920eb6c3a5c3f1ec9110f38fd34589"},
    {"some one_fifth_rule simple total reset", "b0b344a6ea520cd6710344eb0f9965a41889042342db8bb65c19fce4a4862e7b"},
    {"some one_fifth_rule simple total carry", "41b5eb786c505188010eab1734c72d7ccf47456f72a3ff377f24e5d9ba591ea7"},
    {"some one_fifth_rule annealing per_component reset",
     "e9d0343f9aa47eab172df9a8eabb14d28a114b313c47d35c377517d2ea57b1cb"},
    {"some one_fifth_rule annealing per_component carry",
     "24d36e2d3e82085b8200d625105cf65548caae5085a08cadf5c420dd08f4cd3e"},
    {"some one_fifth_rule annealing total reset", "db679b8518a4aa025e2cc8c8907d50ce4f0db50bdcb82705add8343621e8dc00"},
    {"some one_fifth_rule annealing total carry", "97a4ad0669769a29ae481cd34001868372410df17c7cc7de7a3d18d514f42286"},
};

Job job_of(std::string_view choices) {
  Job job = job_with({{"cycles", whole(200)},
                      {"equilibrium_disturbance", whole(25)},
                      {"system_disturbance", whole(25)},
                      {"temperature", 20.0},
                      {"required_stability", whole(75)},
                      {"required_distance", whole(25)}});
  for (const char* name : {"mutation", "steps", "acceptance", "criterion", "posture"}) {
    const auto end = choices.find(' ');
    job.parameters.set(name, std::string(choices.substr(0, end)));
    choices = end == std::string_view::npos ? "" : choices.substr(end + 1);
  }
  return job;
}

TEST(GoldenJobs, EveryMutationStepAcceptanceCriterionAndPostureHasItsDigest) {
  for (const auto& [choices, digest] : golden_jobs) EXPECT_EQ(digest_of(job_of(choices)), digest) << choices;
}

std::string digest_with(std::initializer_list<Setting> settings) {
  Job job = job_with({{"cycles", whole(200)}, {"system_disturbance", whole(75)}});
  for (const auto& [name, value] : settings) job.parameters.set(name, value);
  return digest_of(job);
}

TEST(GoldenJobs, EveryOtherOperatorHasItsDigest) {
  EXPECT_EQ(digest_with({{"objective", text("maximise")}, {"steps", text("normal")}}),
            "cd62d322b4fe40694ddc38216c455f1b1eb4bd8b378bdab2a7b13150d0b5cf3c");
  EXPECT_EQ(digest_with(
                {{"step_variance", text("root_error")}, {"steps", text("normal")}, {"acceptance", text("annealing")}}),
            "15f35d62ea641068a34207beb3e7df3c33ad53e10e8a13c4152d6e6ed69271d2");
  EXPECT_EQ(digest_with({{"acceptance", text("annealing")}, {"temperature", 40.0}, {"cooling", 0.97}}),
            "7cf304a34087c9f8888e84781196d4d99efbe2cfddbd9d67e4215ce4dbce37ba");
  EXPECT_EQ(digest_with({{"steps", text("one_fifth_rule")},
                         {"first_standard_deviation", 2.5},
                         {"success_window", whole(10)},
                         {"standard_deviation_factor", 0.5},
                         {"minimum_standard_deviation", 1.0},
                         {"maximum_standard_deviation", 4.0},
                         {"acceptance", text("annealing")}}),
            "2ff5e18b175073e8086c7dc60f61ed6138be11d0754efca27202b5a6637d8ef6");
  EXPECT_EQ(digest_with({{"time_steps", whole(130)}, {"posture", text("carry")}, {"acceptance", text("annealing")}}),
            "3b2d82d4db624dd42fa19c7d40ed203c4bc835a79ce046c25d14c7b4b3b70237");
}

}  // namespace
}  // namespace lamprey::experiment

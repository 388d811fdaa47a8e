#include "sweep_file_cases.hpp"

namespace lamprey::experiment {

// Grouped as in docs/formats/sweep_file.md: the YAML itself, the fields, values, axes, and what only shows in the
// whole.
const std::vector<WrongSweepFile>& wrong_sweep_files() {
  static const std::vector<WrongSweepFile> cases = {
      {"Malformed YAML", R"(name: a
base: {gait: walk
)",
       R"(sweep.yaml:3:1: not valid YAML: end of map flow not found)"},
      {"A duplicate key", R"(name: a
base:
  gait: walk
  gait: walk
)",
       R"(sweep.yaml:4:3: duplicate key 'gait', first used in line 3)"},
      {"An anchor and an alias", R"(name: a
base: &shared {gait: walk}
grids: [*shared]
)",
       R"(sweep.yaml:2:7: anchors (&name) are not allowed; remove it
sweep.yaml:3:9: aliases (*name) are not allowed; write the value out)"},
      {"A tag", R"(name: !text a
)",
       R"(sweep.yaml:1:7: tags (!name) are not allowed; remove '!text')"},
      {"A key that is no name", R"(name: a
base: {[gait]: walk}
)",
       R"(sweep.yaml:2:8: a key must be a name)"},
      {"More than one document", R"(name: a
---
name: b
)",
       R"(sweep.yaml:2:1: a second document begins here, or something that belongs to none; a file holds one document)"},
      {"Too deep", R"(name: a
base: {gait: [[[[[[[walk]]]]]]]}
)",
       R"(sweep.yaml:2:20: lists and mappings are nested more than 8 deep)"},
      {"No mapping", R"(- name: a
)",
       R"(sweep.yaml:1:1: a sweep file is a mapping of name, base, grids and so on; this is a list)"},
      {"An unknown field", R"(name: a
replicate: 3
workers: 8
cycles: 100
)",
       R"(sweep.yaml:2:1: replicate: unknown field 'replicate'; did you mean 'replicates'?
sweep.yaml:3:1: workers: unknown field 'workers'; known are name, description, seed, base, grids, replicates
sweep.yaml:4:1: cycles: is a parameter; it belongs under base, or as an axis under grids)"},
      {"A field of the wrong shape", R"(name: [a]
description:
base: [gait, walk]
grids: {mutation: all}
)",
       R"(sweep.yaml:1:7: name: takes text; this is a list
sweep.yaml:2:1: description: takes text; this is nothing
sweep.yaml:3:7: base: takes a mapping of parameters to values; this is a list
sweep.yaml:4:8: grids: takes a list of mappings of parameters to axes; this is a mapping)"},
      {"A grid, a value or a list of the wrong shape", R"(name: a
base: {gait: [walk]}
grids:
  - mutation
  - mutation: [[all, one]]
)",
       R"(sweep.yaml:2:14: base.gait: takes a single value; this is a list
sweep.yaml:4:5: grids[0]: a grid is a mapping of parameters to axes; this is 'mutation'
sweep.yaml:5:16: grids[1].mutation[0]: takes a single value; this is a list)"},
      {"No name", R"(base: {gait: walk}
)",
       R"(sweep.yaml:1:1: name: no name is given: a name has 1 to 100 letters, digits, '-', '_' and '.')"},
      {"A name that is not allowed", R"(name: my first sweep
)",
       R"(sweep.yaml:1:7: name: 'my first sweep' is not allowed: a name has 1 to 100 letters, digits, '-', '_' and '.')"},
      {"A seed or replicates out of range", R"(name: a
seed: -1
replicates: 0
)",
       R"(sweep.yaml:2:7: seed: '-1' is not allowed: seed takes a whole number from 0 to 18446744073709551615
sweep.yaml:3:13: replicates: '0' is not allowed: replicates takes a whole number from 1 to 1000000)"},
      {"An unknown parameter", R"(name: a
base: {gaitt: walk}
grids:
  - {speed: 1}
)",
       R"(sweep.yaml:2:8: base.gaitt: unknown parameter 'gaitt'; did you mean 'gait'?
sweep.yaml:4:6: grids[0].speed: unknown parameter 'speed'; known are robot, network, gait, mutation, steps, acceptance, equilibrium_disturbance, mutation_size, system_disturbance, required_stability, required_distance, required_fuel, cycles, time_steps, objective, criterion, posture, temperature, cooling, step_variance, first_standard_deviation, success_window, standard_deviation_factor, minimum_standard_deviation, maximum_standard_deviation)"},
      {"An unknown choice", R"(name: a
base: {gait: wlak}
grids:
  - mutation: [all, two]
)",
       R"(sweep.yaml:2:14: base.gait: 'wlak' is not known: gait takes only walk; did you mean 'walk'?
sweep.yaml:4:21: grids[0].mutation[1]: 'two' is not known: mutation takes one of all, one, some)"},
      {"A value of the wrong kind", R"(name: a
base:
  mutation_size: 50%
  cycles: 2.5
  time_steps: yes
  required_fuel: "100"
  required_distance: 050
  gait:
)",
       R"(sweep.yaml:3:18: base.mutation_size: '50%' is not a whole number: mutation_size takes a whole number from 0 to 100 (%)
sweep.yaml:4:11: base.cycles: '2.5' is not a whole number: cycles takes a whole number from 1 to 10000000
sweep.yaml:5:15: base.time_steps: 'yes' is not a whole number: time_steps takes a whole number from 1 to 10000 (steps)
sweep.yaml:6:18: base.required_fuel: '100' is text: required_fuel takes a whole number from 0 to 100 (%); write the number without quotes and leading zeros
sweep.yaml:7:22: base.required_distance: '050' is text: required_distance takes a whole number from 0 to 100 (%); write the number without quotes and leading zeros
sweep.yaml:8:3: base.gait: no value is given: gait takes only walk)"},
      {"A value out of range", R"(name: a
base: {acceptance: annealing, temperature: 0, cooling: 1e999}
grids:
  - {mutation_size: [25, 101], cycles: 0}
)",
       R"(sweep.yaml:2:44: base.temperature: 0 is out of range: temperature takes a number from 1e-09 to 1e+09 (fitness)
sweep.yaml:2:56: base.cooling: '1e999' is not a number: cooling takes a number from 0.5 to 1
sweep.yaml:4:26: grids[0].mutation_size[1]: 101 is out of range: mutation_size takes a whole number from 0 to 100 (%)
sweep.yaml:4:40: grids[0].cycles[0]: 0 is out of range: cycles takes a whole number from 1 to 10000000)"},
      {"An empty axis, an empty grid", R"(name: a
grids:
  - mutation: []
  - {}
)",
       R"(sweep.yaml:3:5: grids[0].mutation: has no values: mutation takes one of all, one, some
sweep.yaml:4:5: grids[1]: has no axes; leave it out, or give it at least one)"},
      {"An empty list of grids", R"(name: a
grids: []
)",
       R"(sweep.yaml:2:8: grids: has no grids; leave it out for one job per replicate)"},
      {"A value twice in an axis", R"(name: a
grids:
  - mutation: [all, one, all]
)",
       R"(sweep.yaml:3:26: grids[0].mutation[2]: all is in this axis twice)"},
      {"A range with a wrong or missing part", R"(name: a
grids:
  - mutation_size: {from: 25, to: 101, step: 0}
    cycles: {from: 100, too: 200}
    steps: {from: 1, to: 2, step: 1}
)",
       R"(sweep.yaml:3:35: grids[0].mutation_size.to: 101 is out of range: mutation_size takes a whole number from 0 to 100 (%)
sweep.yaml:3:46: grids[0].mutation_size.step: 0 is out of range: mutation_size takes steps of a whole number above 0
sweep.yaml:4:5: grids[0].cycles.to: no value is given: cycles takes a whole number from 1 to 10000000
sweep.yaml:4:5: grids[0].cycles.step: no value is given: cycles takes steps of a whole number above 0
sweep.yaml:4:25: grids[0].cycles.too: a range has from, to and step; did you mean 'to'?
sweep.yaml:5:5: grids[0].steps: a range needs numbers: steps takes one of uniform, normal, one_fifth_rule)"},
      {"A range that is upside down or endless", R"(name: a
grids:
  - mutation_size: {from: 100, to: 25, step: 25}
    cycles: {from: 1, to: 10000000, step: 1}
)",
       R"(sweep.yaml:3:5: grids[0].mutation_size: the range goes from 100 down to 25; from must not be above to
sweep.yaml:4:5: grids[0].cycles: the range has too many values: the axes of a sweep hold at most 100000 values together)"},
      {"A range of real numbers with too small a step", R"(name: a
base: {acceptance: annealing}
grids:
  - temperature: {from: 1000000, to: 1000000.000000001, step: 1e-13}
)",
       R"(sweep.yaml:4:5: grids[0].temperature: the step is too small to tell its values apart)"},
      {"A parameter in base and as an axis", R"(name: a
base: {mutation: all}
grids:
  - mutation: [all, one]
)",
       R"(sweep.yaml:4:5: grids[0].mutation: is set in base too; keep one of them)"},
      {"An axis that does not apply in part of its grid", R"(name: a
grids:
  - steps: [normal, one_fifth_rule]
    mutation_size: [25, 50]
)",
       R"(sweep.yaml:4:5: grids[0].mutation_size: would repeat jobs, since it does not apply to steps one_fifth_rule: it applies unless steps is one_fifth_rule; give steps one_fifth_rule a grid of its own)"},
      {"An axis that applies nowhere in its grid", R"(name: a
base: {mutation: some}
grids:
  - system_disturbance: 25
)",
       R"(sweep.yaml:4:5: grids[0].system_disturbance: applies nowhere in this grid, which has mutation some: it applies unless mutation is some)"},
      {"A parameter of the base that applies to no job", R"(name: a
base: {temperature: 2}
)",
       R"(sweep.yaml:2:21: base.temperature: applies to no job of this sweep: it applies where acceptance is annealing)"},
      {"Grids that overlap", R"(name: a
grids:
  - {mutation: [all, one], cycles: [100, 200]}
  - {mutation: [one, some], cycles: {from: 50, to: 200, step: 50}}
)",
       R"(sweep.yaml:4:5: grids[1]: has jobs that grids[0] has too (such as mutation one, cycles 100); a sweep runs each job once)"},
      {"Parameters that contradict each other", R"(name: a
base: {objective: maximise, maximum_standard_deviation: 4}
grids:
  - steps: normal
    step_variance: [constant, root_error]
  - steps: one_fifth_rule
    minimum_standard_deviation: [0.5, 5]
)",
       R"(sweep.yaml:5:5: grids[0].step_variance: step_variance root_error contradicts objective maximise: the root of the error needs a target: under maximise the error is minus the fitness
sweep.yaml:7:5: grids[1].minimum_standard_deviation: minimum_standard_deviation 5 contradicts maximum_standard_deviation 4: the minimum must not be above the maximum)"},
      {"Too many jobs", R"(name: a
grids:
  - cycles: {from: 1, to: 20000, step: 1}
    time_steps: {from: 1, to: 10000, step: 1}
)",
       R"(sweep.yaml:3:3: grids: the sweep would have 200000000 jobs; at most 100000000 are allowed)"},
      {"Too many replicates", R"(name: a
grids:
  - cycles: {from: 1, to: 1000, step: 1}
replicates: 1000000
)",
       R"(sweep.yaml:4:13: replicates: the sweep would have 1000000000 jobs; at most 100000000 are allowed)"},
  };
  return cases;
}

}  // namespace lamprey::experiment

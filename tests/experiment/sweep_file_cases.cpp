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
sweep.yaml:3:1: workers: unknown field 'workers'; known are name, description, seed, base, environment, grids, replicates, priority, max_concurrent, time_limit, attempts, fail_fast, stop_when, needs, tags
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
      {"A field of the execution that is wrong", R"(name: a
priority: 1001
max_concurrent: 0
time_limit: 0
attempts: "3"
fail_fast: yes
stop_wen: {failed: 1}
)",
       R"(sweep.yaml:2:11: priority: '1001' is not allowed: priority takes a whole number from -1000 to 1000
sweep.yaml:3:17: max_concurrent: '0' is not allowed: max_concurrent takes a whole number from 1 to 100000000
sweep.yaml:4:13: time_limit: '0' is not allowed: time_limit takes a number of seconds above 0 and up to 31536000
sweep.yaml:5:11: attempts: '3' is not allowed: attempts takes a whole number from 1 to 100
sweep.yaml:6:12: fail_fast: 'yes' is not allowed: fail_fast takes true or false
sweep.yaml:7:1: stop_wen: unknown field 'stop_wen'; did you mean 'stop_when'?)"},
      {"A condition to stop that is wrong", R"(name: a
stop_when:
  faild: 1
  speed: 10
  failed: 0
  done: 2.5
  success_rate: 50
  highest_total: many
)",
       R"(sweep.yaml:3:3: stop_when.faild: unknown measure 'faild'; did you mean 'failed'?
sweep.yaml:4:3: stop_when.speed: unknown measure 'speed'; a measure is failed, done, divergences, success_rate, or a score of the view result such as highest_total
sweep.yaml:5:11: stop_when.failed: 0 is out of range: failed takes a whole number from 1 to 100000000
sweep.yaml:6:9: stop_when.done: 2.5 is out of range: done takes a whole number from 1 to 100000000
sweep.yaml:7:17: stop_when.success_rate: 50 is out of range: success_rate takes a number from 0 to 1
sweep.yaml:8:18: stop_when.highest_total: 'many' is not allowed: highest_total takes a number)"},
      {"Labels and tags that are not allowed", R"(name: a
stop_when: highest_total
needs: [gpu=1, my laboratory, gpu=1, [a]]
tags: {a: b}
)",
       R"(sweep.yaml:2:12: stop_when: takes a mapping of measures to values, such as {failed: 10}; this is 'highest_total'
sweep.yaml:3:16: needs[1]: 'my laboratory' is not allowed: a label has 1 to 64 letters, digits, '-', '_', '.', ':' and '='
sweep.yaml:3:31: needs[2]: gpu=1 is in this list twice
sweep.yaml:3:38: needs[3]: takes text; this is a list
sweep.yaml:4:7: tags: takes a list of tags; this is a mapping)"},
      {"An unknown parameter", R"(name: a
base: {gaitt: walk}
grids:
  - {speed: 1}
)",
       R"(sweep.yaml:2:8: base.gaitt: unknown parameter 'gaitt'; did you mean 'gait'?
sweep.yaml:4:6: grids[0].speed: unknown parameter 'speed'; `lamprey parameters` lists all)"},
      {"An unknown choice", R"(name: a
base: {gait: wlak}
grids:
  - mutation: [all, two]
)",
       R"(sweep.yaml:2:14: base.gait: 'wlak' is not known: gait takes one of walk, trot, pace, gallop, pronk, walk_frames; did you mean 'walk'?
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
sweep.yaml:8:3: base.gait: no value is given: gait takes one of walk, trot, pace, gallop, pronk, walk_frames)"},
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
      {"A sample that cannot be drawn", R"(name: a
grids:
  - required_fuel: {sample: 0, from: 0, to: 100}
    push_factor: {sample: 3, from: 0, to: 1, step: 0.5}
    mutation: {sample: 2, from: 0, to: 1}
    required_distance: {sample: 5, from: 1, to: 4}
    cycles: {sample: 200000, from: 1, to: 10000000}
    time_steps: {sample: 2, from: 200, to: 100}
    mutation_size: {sample: 2, from: 200, two: 100}
)",
       R"(sweep.yaml:3:29: grids[0].required_fuel.sample: '0' is not allowed: sample takes a whole number from 1; the axes of a sweep hold at most 100000 values together
sweep.yaml:4:52: grids[0].push_factor.step: a sample has no step; keep step or sample
sweep.yaml:5:5: grids[0].mutation: a sample needs numbers: mutation takes one of all, one, some
sweep.yaml:6:33: grids[0].required_distance.sample: there are not 5 different values from 1 to 4
sweep.yaml:7:22: grids[0].cycles.sample: '200000' is not allowed: sample takes a whole number from 1; the axes of a sweep hold at most 100000 values together
sweep.yaml:8:5: grids[0].time_steps: the range goes from 200 down to 100; from must not be above to
sweep.yaml:9:5: grids[0].mutation_size.to: no value is given: mutation_size takes a whole number from 0 to 100 (%)
sweep.yaml:9:38: grids[0].mutation_size.from: 200 is out of range: mutation_size takes a whole number from 0 to 100 (%)
sweep.yaml:9:43: grids[0].mutation_size.two: an axis has values; or from, to and step; or sample, from and to; and perhaps where; did you mean 'to'?)"},
      {"A zip of the wrong shape", R"(name: a
grids:
  - zip: [required_distance, required_fuel]
  - zip: {}
  - zip: {required_distance: 25, required_fuel: []}
  - zip: {required_distanse: [25, 50]}
)",
       R"(sweep.yaml:3:10: grids[0].zip: takes a mapping of parameters to lists of equal length; this is a list
sweep.yaml:4:10: grids[1].zip: has no parameters; leave it out
sweep.yaml:5:11: grids[2].zip.required_distance: takes a list as long as the others of the zip; this is '25'
sweep.yaml:5:34: grids[2].zip.required_fuel: has no values: required_fuel takes a whole number from 0 to 100 (%)
sweep.yaml:6:11: grids[3].zip.required_distanse: unknown parameter 'required_distanse'; did you mean 'required_distance'?)"},
      {"A zip of lists that differ in length", R"(name: a
grids:
  - zip:
      required_stability: [25, 50, 75]
      required_distance: [75, 50]
)",
       R"(sweep.yaml:5:7: grids[0].zip.required_distance: has 2 values, but required_stability has 3 values: the lists of a zip advance together)"},
      {"A zip with wrong values", R"(name: a
base: {required_fuel: 50}
grids:
  - zip: {required_stability: [25, 50, 25], required_distance: [75, 50, 75]}
  - zip: {required_stability: [25, 101], required_distance: [75, [50]]}
  - zip: {required_stability: [25, 50]}
    required_stability: [75, 100]
  - zip: {required_fuel: [25, 75]}
)",
       R"(sweep.yaml:4:40: grids[0].zip.required_stability[2]: the zip has required_stability 25, required_distance 75 twice
sweep.yaml:5:36: grids[1].zip.required_stability[1]: 101 is out of range: required_stability takes a whole number from 0 to 100 (%)
sweep.yaml:5:66: grids[1].zip.required_distance[1]: takes a single value; this is a list
sweep.yaml:7:5: grids[2].required_stability: is in this grid's zip too; keep one of them
sweep.yaml:8:11: grids[3].required_fuel: is set in base too; keep one of them)"},
      {"An axis of the wrong shape beside a where", R"(name: a
grids:
  - steps: [uniform, normal, one_fifth_rule]
    mutation_size: {where: {steps: uniform}}
    cycles: {values: [10, 20], from: 10, where: steps}
    time_steps: {values: {from: 10, to: 20, step: 10}, were: {steps: uniform}}
    required_fuel: {values: [], where: {}}
)",
       R"(sweep.yaml:4:5: grids[0].mutation_size: has no values: mutation_size takes a whole number from 0 to 100 (%)
sweep.yaml:5:5: grids[0].cycles: has both values and a range; keep one of them
sweep.yaml:5:49: grids[0].cycles.where: takes a mapping of axes that stand before this one to some of their values; this is 'steps'
sweep.yaml:6:26: grids[0].time_steps.values: takes a list of values; this is a mapping
sweep.yaml:6:56: grids[0].time_steps.were: an axis has values; or from, to and step; or sample, from and to; and perhaps where; did you mean 'where'?
sweep.yaml:7:29: grids[0].required_fuel.values: has no values: required_fuel takes a whole number from 0 to 100 (%)
sweep.yaml:7:40: grids[0].required_fuel.where: names no axis; leave it out)"},
      {"A where that names no axis", R"(name: a
base: {acceptance: simple}
grids:
  - cycles: {from: 100, to: 300, step: 100}
    mutation_size:
      values: [25, 50]
      where: {stepps: uniform, steps: uniform, acceptance: annealing, mutation_size: 25, cycles: 100}
    steps: [uniform, one_fifth_rule]
)",
       R"(sweep.yaml:7:15: grids[0].mutation_size.where.stepps: unknown parameter 'stepps'; did you mean 'steps'?
sweep.yaml:7:32: grids[0].mutation_size.where.steps: stands after mutation_size in this grid; put it before
sweep.yaml:7:48: grids[0].mutation_size.where.acceptance: is no axis of this grid
sweep.yaml:7:71: grids[0].mutation_size.where.mutation_size: is this axis itself; `where` names axes that stand before it
sweep.yaml:7:90: grids[0].mutation_size.where.cycles: is a range; write its values as a list for `where` to tell them apart)"},
      {"A where with wrong values", R"(name: a
grids:
  - steps: [uniform, one_fifth_rule]
    mutation_size: {values: [25, 50, 25], where: {steps: [normal, unifrom, uniform, uniform]}}
)",
       R"(sweep.yaml:4:38: grids[0].mutation_size.values[2]: 25 is in this axis twice
sweep.yaml:4:59: grids[0].mutation_size.where.steps[0]: normal is not in this grid's axis of steps; add it there, or leave it out
sweep.yaml:4:67: grids[0].mutation_size.where.steps[1]: 'unifrom' is not known: steps takes one of uniform, normal, one_fifth_rule; did you mean 'uniform'?
sweep.yaml:4:76: grids[0].mutation_size.where.steps[2]: uniform is named twice)"},
      {"An axis whose where never holds", R"(name: a
grids:
  - mutation: [all, one]
    steps: {values: [uniform, normal], where: {mutation: all}}
    mutation_size: {values: [25, 50], where: {mutation: one, steps: uniform}}
)",
       R"(sweep.yaml:5:5: grids[0].mutation_size: applies nowhere: its `where` never holds in this grid)"},
      {"A where that leaves out too little", R"(name: a
grids:
  - steps: [uniform, normal, one_fifth_rule]
    acceptance: [simple, annealing]
    mutation_size: {values: [25, 50], where: {acceptance: annealing}}
)",
       R"(sweep.yaml:5:5: grids[0].mutation_size: would repeat jobs, since it does not apply to steps one_fifth_rule: it applies where trainer is rtea or hybrid and unless network is tonic and unless steps is one_fifth_rule; say `where` it does, or give steps one_fifth_rule a grid of its own)"},
      {"A change of the environment that is wrong", R"(name: a
base: {objective: maximise}
environment:
  - {at: 500, required_distance: 125, gait: trot}
  - {at: 400, push_facter: 0.5}
  - {required_fuel: 50}
  - {at: 900}
  - {at: 1e3, required_fuel: [50]}
  - at 950
)",
       R"(sweep.yaml:4:34: environment[0].required_distance: 125 is out of range: required_distance takes a whole number from 0 to 100 (%)
sweep.yaml:4:39: environment[0].gait: 'gait' cannot change in a run; what can change is required_stability, required_distance, required_fuel, push_factor, ground_level_front_left, ground_level_front_right, ground_level_back_left, ground_level_back_right
sweep.yaml:5:10: environment[1].at: cycle 400 does not come after cycle 500: changes are written in the order of their cycles
sweep.yaml:5:15: environment[1].push_facter: unknown parameter 'push_facter'; did you mean 'push_factor'?
sweep.yaml:6:5: environment[2].at: no cycle is given: a change begins at a cycle from 1 to 10000000
sweep.yaml:7:5: environment[3]: nothing changes at this cycle; leave it out, or name a parameter and its new value
sweep.yaml:8:10: environment[4].at: '1e3' is not a cycle: a change begins at a cycle from 1 to 10000000
sweep.yaml:8:30: environment[4].required_fuel: takes a single value; this is a list
sweep.yaml:9:5: environment[5]: a change is a mapping such as {at: 500, required_distance: 25}; this is 'at 950')"},
      {"An environment of the wrong shape", R"(name: a
environment: 500 required_distance=25
)",
       R"(sweep.yaml:2:14: environment: takes a list of changes such as {at: 500, required_distance: 25}; this is '500 required_distance=25')"},
      {"An environment without changes", R"(name: a
environment: []
)",
       R"(sweep.yaml:2:14: environment: has no changes; leave it out for an environment that never changes)"},
      {"An environment beside one in the base", R"(name: a
base: {objective: maximise, environment: 500 required_distance=25}
environment:
  - {at: 400, required_distance: 25}
)",
       R"(sweep.yaml:4:3: environment: is set in base too; keep one of them)"},
      {"A schedule that is wrong", R"(name: a
base: {objective: maximise}
grids:
  - environment:
      - 500
      - required_distance=25
      - 500 required_distance
      - 500 required_distanse=25
      - 500 required_distance=125
      - 500 required_distance=25 required_distance=50
      - 500 required_distance=25; 500 required_fuel=25
      - 500 required_distance=25;
      - 0 required_distance=25
      - 500 ground_level_front_left=2.5
)",
       R"(sweep.yaml:5:9: grids[0].environment[0]: nothing changes at cycle 500: a change is a cycle and what changes then, such as '500 required_distance=25'
sweep.yaml:6:9: grids[0].environment[1]: 'required_distance=25' is not a cycle: a change begins at a cycle from 1 to 10000000
sweep.yaml:7:9: grids[0].environment[2]: at cycle 500: 'required_distance' is not of the form PARAMETER=VALUE
sweep.yaml:8:9: grids[0].environment[3]: at cycle 500: unknown parameter 'required_distanse'; did you mean 'required_distance'?
sweep.yaml:9:9: grids[0].environment[4]: at cycle 500: 125 is out of range: required_distance takes a whole number from 0 to 100 (%)
sweep.yaml:10:9: grids[0].environment[5]: at cycle 500: required_distance is given twice
sweep.yaml:11:9: grids[0].environment[6]: cycle 500 does not come after cycle 500: changes are written in the order of their cycles
sweep.yaml:12:9: grids[0].environment[7]: a change is missing beside a ';': a change is a cycle and what changes then
sweep.yaml:13:9: grids[0].environment[8]: 0 is out of range: a change begins at a cycle from 1 to 10000000
sweep.yaml:14:9: grids[0].environment[9]: at cycle 500: '2.5' is not a whole number: ground_level_front_left takes a whole number from 0 to 30 (positions))"},
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
       R"(sweep.yaml:4:5: grids[0].mutation_size: would repeat jobs, since it does not apply to steps one_fifth_rule: it applies where trainer is rtea or hybrid and unless network is tonic and unless steps is one_fifth_rule; say `where` it does, or give steps one_fifth_rule a grid of its own)"},
      {"An axis that applies nowhere in its grid", R"(name: a
base: {mutation: some}
grids:
  - system_disturbance: 25
)",
       R"(sweep.yaml:4:5: grids[0].system_disturbance: applies nowhere in this grid, which has mutation some: it applies where trainer is rtea or hybrid and unless network is recurrent_pair or feed_forward_pair and unless network is tonic and unless mutation is some)"},
      {"A parameter of the base that applies to no job", R"(name: a
base: {temperature: 2}
)",
       R"(sweep.yaml:2:21: base.temperature: applies to no job of this sweep: it applies where trainer is rtea or hybrid and unless network is tonic and where acceptance is annealing)"},
      {"Grids that overlap", R"(name: a
grids:
  - {mutation: [all, one], cycles: [100, 200]}
  - {mutation: [one, some], cycles: {from: 50, to: 200, step: 50}}
)",
       R"(sweep.yaml:4:5: grids[1]: has jobs that grids[0] has too (such as mutation one, cycles 100); a sweep runs each job once)"},
      {"A schedule that goes on after the last cycle", R"(name: a
base: {objective: maximise}
environment:
  - {at: 500, required_distance: 25}
  - {at: 800, required_distance: 100}
grids:
  - cycles: [800, 1000]
)",
       R"(sweep.yaml:7:5: grids[0].cycles: environment '500 required_distance=25; 800 required_distance=100' contradicts cycles 800: it changes at cycle 800, and cycles are numbered from 0 to 799)"},
      {"Choices that do not go together", R"(name: a
grids:
  - robot: biped
  - network: [four_mother, one_mother]
    gait: [walk, walk_frames]
  - network: tonic
    trainer: [rtea, ii_rtea]
)",
       R"(sweep.yaml:3:5: grids[0].robot: robot biped contradicts network four_mother: the biped has two legs, one for each of two neurons (6.2.1); robot biped goes with network recurrent_pair or feed_forward_pair
sweep.yaml:5:5: grids[1].gait: gait walk_frames contradicts network four_mother: the nine-step frames of fig. 7.13 are those of eight neurons and of one mother; gait walk_frames goes with network one_mother or recurrent_eight; give what goes together a grid of its own
sweep.yaml:6:5: grids[2].network: network tonic contradicts trainer ii_rtea: a change of gait is a mutation of the tonic input (9.3); network tonic goes with trainer rtea; give what goes together a grid of its own)"},
      {"Parameters that contradict each other", R"(name: a
base: {objective: maximise, maximum_standard_deviation: 4}
grids:
  - steps: normal
    step_variance: [constant, root_error]
  - steps: one_fifth_rule
    minimum_standard_deviation: [0.5, 5]
)",
       R"(sweep.yaml:5:5: grids[0].step_variance: step_variance root_error contradicts objective maximise: the root of the error needs a target: under maximise the error is minus the fitness; step_variance root_error goes with objective target; give what goes together a grid of its own
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

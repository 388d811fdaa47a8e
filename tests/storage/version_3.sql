-- A database of schema version 3, as its program left it: sqlite3 .dump, with the header's numbers that it leaves out. Rows
-- without an outcome, attempts, the checkpoint, the divergence and what people wished have been put in by hand.
PRAGMA application_id = 1280135250;
PRAGMA user_version = 3;
PRAGMA foreign_keys=OFF;
BEGIN TRANSACTION;
CREATE TABLE IF NOT EXISTS "sweep" (
  "sweep" INTEGER PRIMARY KEY AUTOINCREMENT,
  "id" TEXT NOT NULL UNIQUE CHECK (length(id) = 32),
  "name" TEXT NOT NULL UNIQUE,
  "state" TEXT NOT NULL CHECK (state IN ('running', 'paused', 'finished', 'cancelling', 'cancelled', 'deleting')),
  "specification" BLOB NOT NULL,
  "source" TEXT NOT NULL,
  "seed" INTEGER NOT NULL,
  "replicates" INTEGER NOT NULL CHECK (replicates > 0),
  "jobs" INTEGER NOT NULL CHECK (jobs > 0),
  "science_version" INTEGER NOT NULL,
  "checksum" BLOB NOT NULL CHECK (length(checksum) = 32),
  "created" INTEGER NOT NULL,
  "ended" INTEGER,
  "last_result" INTEGER,
  "done" INTEGER NOT NULL DEFAULT 0,
  "failed" INTEGER NOT NULL DEFAULT 0,
  "quarantined" INTEGER NOT NULL DEFAULT 0,
  "cancelled" INTEGER NOT NULL DEFAULT 0,
  "divergences" INTEGER NOT NULL DEFAULT 0,
  "reused" INTEGER NOT NULL DEFAULT 0,
  "audited" INTEGER NOT NULL DEFAULT 0,
  "fresh" INTEGER NOT NULL DEFAULT 0 CHECK (fresh IN (0, 1)),
  "archived" INTEGER NOT NULL DEFAULT 0 CHECK (archived IN (0, 1)),
  "reason" TEXT,
  "execution" BLOB NOT NULL DEFAULT X'',
  CHECK (done + failed + quarantined + cancelled <= jobs), CHECK (reused <= done)
);
INSERT INTO sweep VALUES(1,'c8d3f131048681b96875ebdfffa8a3cb','changes','finished',X'0a076368616e67657310d70f180222170a1172657175697265645f64697374616e636512020864220c0a066379636c65731202080c22100a0a74696d655f73746570731202085022170a096f626a656374697665120a1a086d6178696d69736522130a067265636f726412091a0764657461696c7322230a0b656e7669726f6e6d656e7412141a12332072657175697265645f6675656c3d38302a520a180a086d75746174696f6e12051a03616c6c12051a036f6e650a110a05737465707312081a066e6f726d616c0a230a0a616363657074616e636512081a0673696d706c65120b1a09616e6e65616c696e67',replace('# Operators and one change of the weights, for a few cycles.\nname: changes\nseed: 2007\nbase: {required_distance: 50, cycles: 6, time_steps: 40, objective: maximise, record: details}\nenvironment:\n  - {at: 3, required_fuel: 80}\ngrids:\n  - mutation: [all, one]\n    steps: [normal]\n    acceptance: [simple, annealing]\nreplicates: 2\n','\n',char(10)),2007,2,8,1,X'02213754eee25752d33e61c84cee2cd00d3eea0cfee6744a2cf5c982efa5577c',1795377459773,1795377459953,1795377459953,8,0,0,0,1,0,3,0,1,NULL,X'');
INSERT INTO sweep VALUES(2,'6587daa69c1f789d43e7141f27b9236f','once-more','finished',X'0a096f6e63652d6d6f726510d70f180122170a1172657175697265645f64697374616e636512020864220c0a066379636c65731202080c22100a0a74696d655f73746570731202085022170a096f626a656374697665120a1a086d6178696d69736522130a067265636f726412091a0764657461696c7322230a0b656e7669726f6e6d656e7412141a12332072657175697265645f6675656c3d38302a490a190a086d75746174696f6e12051a036f6e6512061a04736f6d650a110a05737465707312081a066e6f726d616c0a190a0a616363657074616e6365120b1a09616e6e65616c696e673a09080642056472616674',replace('name: once-more\nseed: 2007\nbase: {required_distance: 50, cycles: 6, time_steps: 40, objective: maximise, record: details}\nenvironment:\n  - {at: 3, required_fuel: 80}\ngrids:\n  - mutation: [one, some]\n    steps: [normal]\n    acceptance: [annealing]\npriority: 3\ntags: [draft]\n','\n',char(10)),2007,1,2,1,X'5056b2ba3da3ab128011d0b1c29648ee89b574a9049b056c2a3d15a1174ab133',1795377460918,1795377460987,1795377460987,2,0,0,0,0,1,0,0,0,NULL,X'080642056472616674');
INSERT INTO sweep VALUES(3,'c1320a8d4b9705be02f0091266611ae3','half','paused',X'0a0468616c6610818080808080808080011801220c0a066379636c65731202080422160a07747261696e6572120b1a097061676d6f5f7367612a1e0a1c0a0d72657175697265645f6675656c12020832120208641203089601',replace('name: half\nseed: 9223372036854775809\nbase: {cycles: 2, trainer: pagmo_sga}\ngrids:\n  - required_fuel: [25, 50, 75]\n','\n',char(10)),-9223372036854775807,1,3,1,X'd19de57160396d1d275ba1355321edd57122c542998ce58e89e4796ab317fa43',1795377462710,NULL,1795377462840,1,0,1,0,0,0,0,0,0,'it is late',X'');
CREATE TABLE IF NOT EXISTS "job" (
  "sweep" INTEGER NOT NULL REFERENCES sweep,
  "job" INTEGER NOT NULL CHECK (job >= 0),
  "state" TEXT NOT NULL CHECK (state IN ('done', 'failed', 'quarantined', 'cancelled')),
  "identity" BLOB CHECK (length(identity) = 32),
  "digest" BLOB CHECK (length(digest) = 32),
  "attempt" INTEGER NOT NULL CHECK (attempt > 0),
  "worker" INTEGER,
  "seconds" REAL NOT NULL,
  "ended" INTEGER NOT NULL,
  "reason" TEXT,
  "seed" INTEGER,
  "replicate" INTEGER,
  "expected_stability",
  "expected_distance",
  "expected_fuel",
  "expected_total",
  "initial_stability",
  "initial_distance",
  "initial_fuel",
  "initial_total",
  "evolved_stability",
  "evolved_distance",
  "evolved_fuel",
  "evolved_total",
  "highest_stability",
  "highest_distance",
  "highest_fuel",
  "highest_total",
  "final_stability",
  "final_distance",
  "final_fuel",
  "final_total",
  "cycles_run" INTEGER,
  "accepted" INTEGER,
  "successes" INTEGER,
  "success_rate",
  "parameters" TEXT,
  "trace" TEXT,
  "measures" TEXT,
  "queue_seconds" REAL,
  "waited_seconds" REAL,
  "commit_seconds" REAL,
  "reused_from_sweep" INTEGER,
  "reused_from_job" INTEGER,
  UNIQUE (sweep, job),
  CHECK ((state = 'done') = (digest IS NOT NULL)), CHECK ((state = 'done') = (trace IS NOT NULL)),
  CHECK (state <> 'done' OR (identity IS NOT NULL AND parameters IS NOT NULL))
);
INSERT INTO job VALUES(1,0,'done',X'8eab58e0328c2efe9deb10689f0364e2f7555abc825a75a7d0beb82cebe3f05f',X'c19e0ea0fe3ce0ea9f7395c7aaafc975b74e11188498242da9c7dd9cbd01018a',1,-2486035329266249763,0.0013555220000000000636,1795377459815,NULL,2007,0,100.0,0.0,92.0,173.60000000000002273,87.5,-15.0,85.500000000000000001,165.49999999999999999,87.5,-15.0,85.500000000000000001,148.40000000000000568,87.5,-15.0,85.500000000000000001,148.40000000000000568,87.5,-15.0,85.500000000000000001,148.40000000000000568,6,0,0,0.0,'{"robot":"quadruped","network":"four_mother","gait":"walk","actuator":"unit_move","trainer":"rtea","mutation":"all","steps":"normal","acceptance":"simple","equilibrium_disturbance":50,"mutation_size":50,"system_disturbance":100,"required_stability":100,"required_distance":50,"required_fuel":100,"push_factor":1,"ground_level_front_left":10,"ground_level_front_right":10,"ground_level_back_left":10,"ground_level_back_right":10,"cycles":6,"time_steps":40,"objective":"maximise","criterion":"per_component","posture":"reset","environment":"3 required_fuel=80","record":"details","step_variance":"constant"}','[]','[["environment_expected_total",0,173.60000000000002],["off_line_performance",0,156.95],["on_line_performance",0,121.25333333333334],["recovered",0,0]]',0.024141914000000000428,3.3739999999999998833e-05,0.025191963000000001243,NULL,NULL);
INSERT INTO job VALUES(1,1,'done',X'8a094ccaf05a730aa60478be458d0450a34713e50e421862a7fda668ce9fc4dc',X'4b1dda8579b3eced1359ee149af16d6f66cedc359b61024b4ddd4266e9d64bc6',1,-2486035329266249763,0.00010401499999999999938,1795377459815,NULL,2007,0,100.0,0.0,92.0,173.60000000000002273,100.0,-2.5,86.0,184.74999999999999999,100.0,0.0,87.099999999999994319,169.68000000000000681,100.0,0.0,87.099999999999994319,169.68000000000000681,100.0,0.0,87.099999999999994319,169.68000000000000681,6,2,1,0.16666666666666665741,'{"robot":"quadruped","network":"four_mother","gait":"walk","actuator":"unit_move","trainer":"rtea","mutation":"all","steps":"normal","acceptance":"annealing","equilibrium_disturbance":50,"mutation_size":50,"system_disturbance":100,"required_stability":100,"required_distance":50,"required_fuel":100,"push_factor":1,"ground_level_front_left":10,"ground_level_front_right":10,"ground_level_back_left":10,"ground_level_back_right":10,"cycles":6,"time_steps":40,"objective":"maximise","criterion":"per_component","posture":"reset","environment":"3 required_fuel=80","record":"details","temperature":1,"cooling":1,"step_variance":"constant"}','[[1,100,-7.5,86.3,182.55],[5,100,0,87.1,169.68]]','[["environment_expected_total",0,173.60000000000002],["off_line_performance",0,175.75166666666667],["on_line_performance",0,167.715],["parameter_variation",1,1.8274631297699582],["parameter_variation",5,2.472859355759926],["recovered",0,1],["recovery_cycles",0,0]]',0.024141914000000000428,0.006522148999999999655,0.025191963000000001243,NULL,NULL);
INSERT INTO job VALUES(1,2,'done',X'a82d3426c22ab575bfca2dd691219352725c075e819dd1f0656258d7d5f18435',X'4d38d27dfcb3380e888012d7f9808891af226602832727dee56e5e92f19b219a',1,-2486035329266249763,0.00011712399999999999872,1795377459897,NULL,2007,0,100.0,0.0,92.0,173.60000000000002273,100.0,-17.5,84.499999999999999998,175.75,100.0,-15.0,84.900000000000005687,160.42000000000001591,100.0,-15.0,84.900000000000005687,160.42000000000001591,100.0,-15.0,84.900000000000005687,160.42000000000001591,6,5,2,0.33333333333333331482,'{"robot":"quadruped","network":"four_mother","gait":"walk","actuator":"unit_move","trainer":"rtea","mutation":"one","steps":"normal","acceptance":"simple","equilibrium_disturbance":50,"mutation_size":50,"system_disturbance":100,"required_stability":100,"required_distance":50,"required_fuel":100,"push_factor":1,"ground_level_front_left":10,"ground_level_front_right":10,"ground_level_back_left":10,"ground_level_back_right":10,"cycles":6,"time_steps":40,"objective":"maximise","criterion":"per_component","posture":"reset","environment":"3 required_fuel=80","record":"details","step_variance":"constant"}','[[0,100,-15,84.7,177.2],[1,100,-15,84.7,177.2],[2,100,-15,84.7,177.2],[4,100,-15,84.9,160.42000000000002],[5,100,-15,84.9,160.42000000000002]]','[["environment_expected_total",0,173.60000000000002],["off_line_performance",0,169.19500000000002],["on_line_performance",0,168.93833333333336],["parameter_variation",0,0.347018003746789],["parameter_variation",1,0.6490137030969487],["parameter_variation",2,0.986847708376964],["parameter_variation",4,1.240539332795977],["parameter_variation",5,1.547007174199115],["recovered",0,0]]',0.057671179000000002967,0.00021053200000000000971,0.075187171999999996563,NULL,NULL);
INSERT INTO job VALUES(1,3,'done',X'05d1ad35b60b143e7e81dfdaba1d281bd43ea62cbcaf7482173e21ee58b09ccc',X'4d5437f961cb1f56351d388b4d5b92c07837f1e5f3abdd45804c199c0f42cade',1,-2486035329266249763,2.9142999999999998632e-05,1795377459897,NULL,2007,0,100.0,0.0,92.0,173.60000000000002273,62.5,0.0,88.599999999999994315,151.09999999999999431,62.5,0.0,88.200000000000002842,133.06000000000000227,62.5,0.0,88.200000000000002842,133.06000000000000227,62.5,0.0,88.200000000000002842,133.06000000000000227,6,6,1,0.16666666666666665741,'{"robot":"quadruped","network":"four_mother","gait":"walk","actuator":"unit_move","trainer":"rtea","mutation":"one","steps":"normal","acceptance":"annealing","equilibrium_disturbance":50,"mutation_size":50,"system_disturbance":100,"required_stability":100,"required_distance":50,"required_fuel":100,"push_factor":1,"ground_level_front_left":10,"ground_level_front_right":10,"ground_level_back_left":10,"ground_level_back_right":10,"cycles":6,"time_steps":40,"objective":"maximise","criterion":"per_component","posture":"reset","environment":"3 required_fuel=80","record":"details","temperature":1,"cooling":1,"step_variance":"constant"}','[[0,62.5,0,87.6,150.1],[1,62.5,0,87.6,150.1],[2,62.5,0,87.6,150.1],[3,62.5,0,88.2,133.06],[4,62.5,0,88.2,133.06],[5,62.5,0,88.2,133.06]]','[["environment_expected_total",0,173.60000000000002],["off_line_performance",0,142.07999999999996],["on_line_performance",0,141.57999999999996],["parameter_variation",0,0.4058573127448673],["parameter_variation",1,0.7281257463433775],["parameter_variation",2,0.9485552040421543],["parameter_variation",3,1.1804160159760753],["parameter_variation",4,1.5073011480077692],["parameter_variation",5,1.5389557110646788],["recovered",0,0]]',0.057671179000000002967,0.00034513200000000000171,0.075187171999999996563,NULL,NULL);
INSERT INTO job VALUES(1,4,'done',X'e7ba327f6eee15f00b132ce6e0c71f29e016657e624398be78710ba9b4c4f55b',X'ba193c801d6ad81b585e8c4a06a5d19670c64939f73424e12cda79b31ebaf50c',1,-2486035329266249763,3.3219000000000001619e-05,1795377459897,NULL,2007,1,100.0,0.0,92.0,173.60000000000002273,60.0,-7.5,92.099999999999994319,148.34999999999999431,60.0,-7.5,92.099999999999994319,129.93000000000000681,60.0,-7.5,92.099999999999994319,129.93000000000000681,60.0,-7.5,92.099999999999994319,129.93000000000000681,6,0,0,0.0,'{"robot":"quadruped","network":"four_mother","gait":"walk","actuator":"unit_move","trainer":"rtea","mutation":"all","steps":"normal","acceptance":"simple","equilibrium_disturbance":50,"mutation_size":50,"system_disturbance":100,"required_stability":100,"required_distance":50,"required_fuel":100,"push_factor":1,"ground_level_front_left":10,"ground_level_front_right":10,"ground_level_back_left":10,"ground_level_back_right":10,"cycles":6,"time_steps":40,"objective":"maximise","criterion":"per_component","posture":"reset","environment":"3 required_fuel=80","record":"details","step_variance":"constant"}','[]','[["environment_expected_total",0,173.60000000000002],["off_line_performance",0,139.16500000000005],["on_line_performance",0,113.60333333333335],["recovered",0,0]]',0.057671179000000002967,0.00033528699999999997654,0.075187171999999996563,NULL,NULL);
INSERT INTO job VALUES(1,5,'done',X'25c2505000760a318fa2ac7ce1c4f623f877ce5168ae659837009996d7757d59',X'8af82f2777522c8a9cd01ec611c29855cbe5dd74421e5c7a5cba8a0da968f5ee',1,-2486035329266249763,3.4981999999999998122e-05,1795377459897,NULL,2007,1,100.0,0.0,92.0,173.60000000000002273,97.5,-12.5,84.299999999999997157,175.55000000000001137,100.0,0.0,85.099999999999994312,168.07999999999998408,100.0,0.0,85.099999999999994312,168.07999999999998408,100.0,0.0,85.099999999999994312,168.07999999999998408,6,2,1,0.16666666666666665741,'{"robot":"quadruped","network":"four_mother","gait":"walk","actuator":"unit_move","trainer":"rtea","mutation":"all","steps":"normal","acceptance":"annealing","equilibrium_disturbance":50,"mutation_size":50,"system_disturbance":100,"required_stability":100,"required_distance":50,"required_fuel":100,"push_factor":1,"ground_level_front_left":10,"ground_level_front_right":10,"ground_level_back_left":10,"ground_level_back_right":10,"cycles":6,"time_steps":40,"objective":"maximise","criterion":"per_component","posture":"reset","environment":"3 required_fuel=80","record":"details","temperature":1,"cooling":1,"step_variance":"constant"}','[[0,100,0,84.2,184.2],[5,100,0,85.1,168.07999999999998]]','[["environment_expected_total",0,173.60000000000002],["off_line_performance",0,175.89999999999998],["on_line_performance",0,167.9766666666667],["parameter_variation",0,1.6834385699696486],["parameter_variation",5,2.7033045957578365],["recovered",0,1],["recovery_cycles",0,0]]',0.057671179000000002967,0.0003717920000000000209,0.075187171999999996563,NULL,NULL);
INSERT INTO job VALUES(1,6,'done',X'52a08bb06e0f1cbda419bd82f8bf670f74d9af946bed35830573e2f4f76475e2',X'1a4e6d84fb1d784cabe8f1e74cce16022cecff87a554f83c1687ae5c870c3607',1,-2486035329266249763,0.00011254700000000000511,1795377459953,NULL,2007,1,100.0,0.0,92.0,173.60000000000002273,42.5,-2.5,92.299999999999997159,133.55000000000001136,42.5,-2.5,92.299999999999997159,115.09000000000000341,42.5,-2.5,92.299999999999997159,115.09000000000000341,42.5,-2.5,92.299999999999997159,115.09000000000000341,6,3,0,0.0,'{"robot":"quadruped","network":"four_mother","gait":"walk","actuator":"unit_move","trainer":"rtea","mutation":"one","steps":"normal","acceptance":"simple","equilibrium_disturbance":50,"mutation_size":50,"system_disturbance":100,"required_stability":100,"required_distance":50,"required_fuel":100,"push_factor":1,"ground_level_front_left":10,"ground_level_front_right":10,"ground_level_back_left":10,"ground_level_back_right":10,"cycles":6,"time_steps":40,"objective":"maximise","criterion":"per_component","posture":"reset","environment":"3 required_fuel=80","record":"details","step_variance":"constant"}','[[0,42.5,-2.5,92.3,133.55],[3,42.5,-2.5,92.3,115.09],[4,42.5,-2.5,92.3,115.09]]','[["environment_expected_total",0,173.60000000000002],["off_line_performance",0,125.30333333333336],["on_line_performance",0,122.17833333333336],["parameter_variation",0,0.1830681457446776],["parameter_variation",3,0.5144897249818556],["parameter_variation",4,0.8375504590900238],["recovered",0,0]]',0.13966392999999999169,1.6945000000000001239e-05,0.054336760999999997312,NULL,NULL);
INSERT INTO job VALUES(1,7,'done',X'ef147f3327d71a9377ede2bf1d33feb3ac7909663cc7a99dd3a41d0089b05ce2',X'e8e63b2267f0494a639123f6b551b3bfef24aea6a47cb026a0dd84bb644505bf',1,-2486035329266249763,3.5632000000000000369e-05,1795377459953,NULL,2007,1,100.0,0.0,92.0,173.60000000000002273,-2.5,-12.5,92.90000000000000568,84.15000000000000568,-2.5,-12.5,92.90000000000000568,65.570000000000007388,-2.5,-12.5,92.90000000000000568,65.570000000000007388,-2.5,-12.5,92.90000000000000568,65.570000000000007388,6,3,0,0.0,'{"robot":"quadruped","network":"four_mother","gait":"walk","actuator":"unit_move","trainer":"rtea","mutation":"one","steps":"normal","acceptance":"annealing","equilibrium_disturbance":50,"mutation_size":50,"system_disturbance":100,"required_stability":100,"required_distance":50,"required_fuel":100,"push_factor":1,"ground_level_front_left":10,"ground_level_front_right":10,"ground_level_back_left":10,"ground_level_back_right":10,"cycles":6,"time_steps":40,"objective":"maximise","criterion":"per_component","posture":"reset","environment":"3 required_fuel=80","record":"details","temperature":1,"cooling":1,"step_variance":"constant"}','[[1,-2.5,-12.5,92.9,84.15],[3,-2.5,-12.5,92.9,65.57000000000001],[4,-2.5,-12.5,92.9,65.57000000000001]]','[["environment_expected_total",0,173.60000000000002],["off_line_performance",0,74.86],["on_line_performance",0,71.13000000000001],["parameter_variation",1,0.30096030051582173],["parameter_variation",3,0.4251467248789686],["parameter_variation",4,0.5889602574870985],["recovered",0,0]]',0.13966392999999999169,0.0001473889999999999944,0.054336760999999997312,NULL,NULL);
INSERT INTO job VALUES(2,0,'done',X'05d1ad35b60b143e7e81dfdaba1d281bd43ea62cbcaf7482173e21ee58b09ccc',X'4d5437f961cb1f56351d388b4d5b92c07837f1e5f3abdd45804c199c0f42cade',1,-2486035329266249763,2.9142999999999998632e-05,1795377460987,NULL,2007,0,100.0,0.0,92.0,173.60000000000002273,62.5,0.0,88.599999999999994315,151.09999999999999431,62.5,0.0,88.200000000000002842,133.06000000000000227,62.5,0.0,88.200000000000002842,133.06000000000000227,62.5,0.0,88.200000000000002842,133.06000000000000227,6,6,1,0.16666666666666665741,'{"robot":"quadruped","network":"four_mother","gait":"walk","actuator":"unit_move","trainer":"rtea","mutation":"one","steps":"normal","acceptance":"annealing","equilibrium_disturbance":50,"mutation_size":50,"system_disturbance":100,"required_stability":100,"required_distance":50,"required_fuel":100,"push_factor":1,"ground_level_front_left":10,"ground_level_front_right":10,"ground_level_back_left":10,"ground_level_back_right":10,"cycles":6,"time_steps":40,"objective":"maximise","criterion":"per_component","posture":"reset","environment":"3 required_fuel=80","record":"details","temperature":1,"cooling":1,"step_variance":"constant"}','[[0,62.5,0,87.6,150.1],[1,62.5,0,87.6,150.1],[2,62.5,0,87.6,150.1],[3,62.5,0,88.2,133.06],[4,62.5,0,88.2,133.06],[5,62.5,0,88.2,133.06]]','[["environment_expected_total",0,173.60000000000002],["off_line_performance",0,142.07999999999996],["on_line_performance",0,141.57999999999996],["parameter_variation",0,0.4058573127448673],["parameter_variation",1,0.7281257463433775],["parameter_variation",2,0.9485552040421543],["parameter_variation",3,1.1804160159760753],["parameter_variation",4,1.5073011480077692],["parameter_variation",5,1.5389557110646788],["recovered",0,0]]',NULL,NULL,NULL,1,3);
INSERT INTO job VALUES(2,1,'done',X'0372f97cf2fa63a21ddb480d041b799503770b2366c62c244c2ba98871808c1a',X'741e7d1319627f6b2d340edc6b0c7b94e68f9ade39b1205a4c2f7580bf230546',1,-2486035329266249763,8.8040000000000004105e-05,1795377460987,NULL,2007,0,100.0,0.0,92.0,173.60000000000002273,47.5,0.0,91.900000000000005686,139.40000000000000568,95.0,0.0,84.499999999999999998,162.60000000000002273,95.0,0.0,84.499999999999999998,162.60000000000002273,90.0,0.0,84.299999999999997157,157.43999999999999772,6,3,1,0.16666666666666665741,'{"robot":"quadruped","network":"four_mother","gait":"walk","actuator":"unit_move","trainer":"rtea","mutation":"some","steps":"normal","acceptance":"annealing","equilibrium_disturbance":50,"mutation_size":50,"required_stability":100,"required_distance":50,"required_fuel":100,"push_factor":1,"ground_level_front_left":10,"ground_level_front_right":10,"ground_level_back_left":10,"ground_level_back_right":10,"cycles":6,"time_steps":40,"objective":"maximise","criterion":"per_component","posture":"reset","environment":"3 required_fuel=80","record":"details","temperature":1,"cooling":1,"step_variance":"constant"}','[[1,47.5,0,92.1,139.6],[2,95,0,84.5,179.5],[3,90,0,84.3,157.44]]','[["environment_expected_total",0,173.60000000000002],["off_line_performance",0,157.71666666666667],["on_line_performance",0,150.79999999999998],["parameter_variation",1,0.8515448634953207],["parameter_variation",2,1.4328962215861467],["parameter_variation",3,2.025658089074026],["recovered",0,0]]',0.0,3.9147999999999998554e-05,0.066408224000000001807,NULL,NULL);
INSERT INTO job VALUES(3,0,'done',X'35b61faa7aa4eac2dbff32c09d9c9ab032434db4263c3890b06eebe08494163f',X'e2f92e0de57a4f726d0f6f02ef35ece55167df8c7a2da6f303d6d4d46291a34f',1,-6672408518376412471,0.00010471600000000000504,1795377462775,NULL,-9223372036854775807,0,80.0,60.0,83.0,160.74999999999999999,-24.0,42.0,85.0,39.25,-3.0,50.0,85.0,68.249999999999999998,-3.0,50.0,85.0,68.249999999999999998,-3.0,50.0,85.0,68.249999999999999998,2,2,2,1.0,'{"robot":"quadruped","network":"four_mother","gait":"walk","actuator":"unit_move","trainer":"pagmo_sga","equilibrium_disturbance":50,"required_stability":100,"required_distance":100,"required_fuel":25,"push_factor":1,"ground_level_front_left":10,"ground_level_front_right":10,"ground_level_back_left":10,"ground_level_back_right":10,"cycles":2,"time_steps":100,"objective":"target","record":"changes","population":40}','[[0,13,12,66,41.5],[1,-3,50,85,68.25]]',NULL,0.021645760999999999474,3.9017999999999998105e-05,0.061789160000000002692,NULL,NULL);
INSERT INTO job VALUES(3,1,'quarantined',X'6842412eee7735ea974b556ce8544d29d04c5a03b0c200c97e8d8866bb39767a',NULL,3,-6672408518376412471,4.4697000000000002518e-05,1795377462775,'2 workers were lost with it',-9223372036854775807,0,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,'{"robot":"quadruped","network":"four_mother","gait":"walk","actuator":"unit_move","trainer":"pagmo_sga","equilibrium_disturbance":50,"required_stability":100,"required_distance":100,"required_fuel":50,"push_factor":1,"ground_level_front_left":10,"ground_level_front_right":10,"ground_level_back_left":10,"ground_level_back_right":10,"cycles":2,"time_steps":100,"objective":"target","record":"changes","population":40}',NULL,NULL,0.021645760999999999474,3.2607999999999996796e-05,0.061475193999999996896,NULL,NULL);
CREATE TABLE IF NOT EXISTS "worker" (
  "worker" INTEGER PRIMARY KEY,
  "host" TEXT NOT NULL,
  "process" INTEGER NOT NULL,
  "threads" INTEGER NOT NULL,
  "build" TEXT NOT NULL,
  "dds" TEXT NOT NULL,
  "first_seen" INTEGER NOT NULL,
  "last_seen" INTEGER NOT NULL,
  "flags" TEXT NOT NULL DEFAULT '',
  "processor" TEXT NOT NULL DEFAULT '',
  "instruction_set" TEXT NOT NULL DEFAULT '',
  "labels" TEXT NOT NULL DEFAULT '',
  "draining" INTEGER NOT NULL DEFAULT 0 CHECK (draining IN (0, 1))
);
INSERT INTO worker VALUES(-6672408518376412471,'vm',6110,1,'0.1.0 (6628d72c0dca)','cyclonedds',1795377462188,1795377462188,'GNU 12.2.0 RelWithDebInfo -O2 -g1 -DNDEBUG','AMD EPYC','sse2','lab',1);
INSERT INTO worker VALUES(-2486035329266249763,'vm',6053,1,'0.1.0 (6628d72c0dca)','cyclonedds',1795377459815,1795377459815,'GNU 12.2.0 RelWithDebInfo -O2 -g1 -DNDEBUG','AMD EPYC','sse2','',0);
CREATE TABLE IF NOT EXISTS "event" (
  "event" INTEGER PRIMARY KEY,
  "at" INTEGER NOT NULL,
  "epoch" INTEGER NOT NULL,
  "kind" TEXT NOT NULL,
  "sweep" INTEGER REFERENCES sweep,
  "job" INTEGER,
  "worker" INTEGER,
  "text" TEXT NOT NULL
);
INSERT INTO event VALUES(1,1795377459715,1,'database_opened',NULL,NULL,NULL,'epoch 1');
INSERT INTO event VALUES(2,1795377459773,1,'sweep_submitted',1,NULL,NULL,'changes: 8 jobs');
INSERT INTO event VALUES(3,1795377459815,1,'coordinator_started',NULL,NULL,NULL,'epoch 1, over cyclonedds');
INSERT INTO event VALUES(4,1795377459815,1,'worker_joined',NULL,NULL,-2486035329266249763,'vm/6053');
INSERT INTO event VALUES(5,1795377460013,1,'sweep_finished',1,NULL,NULL,'changes');
INSERT INTO event VALUES(6,1795377460918,1,'sweep_submitted',2,NULL,NULL,'once-more: 2 jobs');
INSERT INTO event VALUES(7,1795377460987,1,'outcomes_reused',2,NULL,NULL,'1 jobs');
INSERT INTO event VALUES(8,1795377461039,1,'sweep_finished',2,NULL,NULL,'once-more');
INSERT INTO event VALUES(9,1795377462012,1,'worker_left',NULL,NULL,-2486035329266249763,'vm/6053');
INSERT INTO event VALUES(10,1795377462131,1,'audit_started',1,NULL,NULL,'changes: 3 jobs');
INSERT INTO event VALUES(11,1795377462188,1,'worker_joined',NULL,NULL,-6672408518376412471,'vm/6110');
INSERT INTO event VALUES(12,1795377462245,1,'audit_finished',1,NULL,NULL,'3 agree, 0 do not');
INSERT INTO event VALUES(13,1795377462710,1,'sweep_submitted',3,NULL,NULL,'half: 3 jobs');
INSERT INTO event VALUES(14,1795377462892,1,'sweep_finished',3,NULL,NULL,'half');
INSERT INTO event VALUES(15,1795377463811,1,'worker_left',NULL,NULL,-6672408518376412471,'vm/6110');
INSERT INTO event VALUES(16,1795377464873,1,'coordinator_stopped',NULL,NULL,NULL,'');
CREATE TABLE IF NOT EXISTS "divergence" (
  "divergence" INTEGER PRIMARY KEY,
  "at" INTEGER NOT NULL,
  "sweep" INTEGER NOT NULL REFERENCES sweep,
  "job" INTEGER NOT NULL,
  "stored" BLOB NOT NULL CHECK (length(stored) = 32),
  "other" BLOB NOT NULL CHECK (length(other) = 32),
  "worker" INTEGER
);
INSERT INTO divergence VALUES(1,1795377465000,1,2,X'4d38d27dfcb3380e888012d7f9808891af226602832727dee56e5e92f19b219a',X'0000000000000000000000000000000000000000000000000000000000000000',8);
CREATE TABLE IF NOT EXISTS "attempt" (
  "attempt" INTEGER PRIMARY KEY,
  "at" INTEGER NOT NULL,
  "sweep" INTEGER NOT NULL REFERENCES sweep,
  "job" INTEGER NOT NULL CHECK (job >= 0),
  "worker" INTEGER,
  "ending" TEXT NOT NULL CHECK (ending IN ('lost', 'refused', 'failed', 'quarantined', 'cancelled')),
  "counted" INTEGER NOT NULL CHECK (counted IN (0, 1)),
  "reason" TEXT NOT NULL
);
INSERT INTO attempt VALUES(1,1795377462000,3,1,7,'lost',1,'vm/1');
INSERT INTO attempt VALUES(2,1795377463000,3,1,8,'lost',1,'');
CREATE TABLE IF NOT EXISTS "checkpoint" (
  "sweep" INTEGER NOT NULL REFERENCES sweep,
  "job" INTEGER NOT NULL CHECK (job >= 0),
  "at" INTEGER NOT NULL,
  "worker" INTEGER,
  "cycle" INTEGER NOT NULL,
  "seconds" REAL NOT NULL,
  "state" BLOB NOT NULL,
  PRIMARY KEY (sweep, job)
);
INSERT INTO checkpoint VALUES(3,2,1795377464000,7,1,0.5,X'0102');
CREATE TABLE IF NOT EXISTS "audit" (
  "audit" INTEGER PRIMARY KEY,
  "id" TEXT NOT NULL UNIQUE CHECK (length(id) = 32),
  "sweep" INTEGER NOT NULL REFERENCES sweep,
  "share" REAL NOT NULL,
  "seed" INTEGER NOT NULL,
  "jobs" INTEGER NOT NULL,
  "agreed" INTEGER NOT NULL DEFAULT 0,
  "diverged" INTEGER NOT NULL DEFAULT 0,
  "created" INTEGER NOT NULL,
  CHECK (agreed + diverged <= jobs)
);
INSERT INTO audit VALUES(1,'b55ef1e54cd878bd1b5a535f0ceaa3e4',1,0.5,1,3,3,0,1795377462131);
CREATE TABLE IF NOT EXISTS "audit_job" (
  "audit" INTEGER NOT NULL REFERENCES audit,
  "job" INTEGER NOT NULL CHECK (job >= 0),
  "at" INTEGER NOT NULL,
  "worker" INTEGER,
  "digest" BLOB NOT NULL CHECK (length(digest) = 32),
  "agreed" INTEGER NOT NULL CHECK (agreed IN (0, 1)),
  PRIMARY KEY (audit, job)
);
INSERT INTO audit_job VALUES(1,0,1795377462188,-6672408518376412471,X'c19e0ea0fe3ce0ea9f7395c7aaafc975b74e11188498242da9c7dd9cbd01018a',1);
INSERT INTO audit_job VALUES(1,6,1795377462188,-6672408518376412471,X'1a4e6d84fb1d784cabe8f1e74cce16022cecff87a554f83c1687ae5c870c3607',1);
INSERT INTO audit_job VALUES(1,7,1795377462188,-6672408518376412471,X'e8e63b2267f0494a639123f6b551b3bfef24aea6a47cb026a0dd84bb644505bf',1);
CREATE TABLE IF NOT EXISTS "database" (
  "row" INTEGER PRIMARY KEY CHECK (row = 1),
  "database_id" TEXT NOT NULL CHECK (length(database_id) = 32),
  "science_version" INTEGER NOT NULL,
  "epoch" INTEGER NOT NULL,
  "created" INTEGER NOT NULL,
  "opened" INTEGER NOT NULL,
  "fingerprint" TEXT NOT NULL
);
INSERT INTO "database" VALUES(1,'0fc79b6cc51dbbdc257f9f09dd4ba1b8',1,1,1795377459612,1795377459715,'bd233b7764ccdda955a50a096d65c851295f21d7230322cb44cad4a98434f4d6');
CREATE TABLE IF NOT EXISTS "schema_version" (
  "version" INTEGER PRIMARY KEY,
  "applied" INTEGER NOT NULL,
  "program" TEXT NOT NULL
);
INSERT INTO schema_version VALUES(3,1795377459612,'0.1.0');
CREATE TABLE IF NOT EXISTS "schema_description" (
  "object" TEXT NOT NULL,
  "column" TEXT NOT NULL,
  "description" TEXT NOT NULL,
  PRIMARY KEY (object, "column")
);
INSERT INTO schema_description VALUES('attempt','','One row per attempt at a job that has not led to the job''s row.');
INSERT INTO schema_description VALUES('attempt','at','When it ended, Unix time in milliseconds');
INSERT INTO schema_description VALUES('attempt','attempt','Key, in the order in which they were noted');
INSERT INTO schema_description VALUES('attempt','counted','1 if it counts towards quarantine');
INSERT INTO schema_description VALUES('attempt','ending','lost (with its worker), refused, or failed, quarantined or cancelled and taken back by a retry');
INSERT INTO schema_description VALUES('attempt','job','Number of the job');
INSERT INTO schema_description VALUES('attempt','reason','Why it ended so; may be empty');
INSERT INTO schema_description VALUES('attempt','sweep','The sweep''s key');
INSERT INTO schema_description VALUES('attempt','worker','Key of the worker that had it; NULL if none did');
INSERT INTO schema_description VALUES('attempts','','One row per attempt at a job that has not led to the job''s row.');
INSERT INTO schema_description VALUES('attempts','counted','1 if it counts towards quarantine');
INSERT INTO schema_description VALUES('attempts','ended','When it ended, UTC');
INSERT INTO schema_description VALUES('attempts','ending','lost (with its worker), refused, or failed, quarantined or cancelled and taken back by a retry');
INSERT INTO schema_description VALUES('attempts','job','Number of the job within its sweep, from 0');
INSERT INTO schema_description VALUES('attempts','reason','Why it ended so');
INSERT INTO schema_description VALUES('attempts','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('attempts','worker','The worker that had it, 16 hex digits; NULL if none did');
INSERT INTO schema_description VALUES('audit','','One row per audit: done jobs of a sweep that other workers compute again.');
INSERT INTO schema_description VALUES('audit','agreed','Number of jobs whose digest was the same again');
INSERT INTO schema_description VALUES('audit','audit','Key, in order of time');
INSERT INTO schema_description VALUES('audit','created','When it was asked for, Unix time in milliseconds');
INSERT INTO schema_description VALUES('audit','diverged','Number of jobs whose digest was another one');
INSERT INTO schema_description VALUES('audit','id','Id, 32 hex digits');
INSERT INTO schema_description VALUES('audit','jobs','Number of jobs to compute again');
INSERT INTO schema_description VALUES('audit','seed','Decides which jobs; 64 bits, those from 2^63 on appear as negative');
INSERT INTO schema_description VALUES('audit','share','Share of the sweep''s done jobs that it asks for, up to 1');
INSERT INTO schema_description VALUES('audit','sweep','The sweep''s key');
INSERT INTO schema_description VALUES('audit_job','','One row per job that an audit has computed again.');
INSERT INTO schema_description VALUES('audit_job','agreed','1 if that is the stored one');
INSERT INTO schema_description VALUES('audit_job','at','When its result came, Unix time in milliseconds');
INSERT INTO schema_description VALUES('audit_job','audit','The audit''s key');
INSERT INTO schema_description VALUES('audit_job','digest','Digest of the outcome that it computed');
INSERT INTO schema_description VALUES('audit_job','job','Number of the job');
INSERT INTO schema_description VALUES('audit_job','worker','Key of the worker that computed it again');
INSERT INTO schema_description VALUES('audits','','One row per audit: how many of the jobs computed again have given the same bits.');
INSERT INTO schema_description VALUES('audits','agreed','Number of jobs whose digest was the same again');
INSERT INTO schema_description VALUES('audits','audit','Id of the audit, 32 hex digits');
INSERT INTO schema_description VALUES('audits','diverged','Number of jobs whose digest was another one');
INSERT INTO schema_description VALUES('audits','jobs','Number of jobs to compute again');
INSERT INTO schema_description VALUES('audits','share','Share of the sweep''s done jobs that it asks for, up to 1');
INSERT INTO schema_description VALUES('audits','started','When it was asked for, UTC');
INSERT INTO schema_description VALUES('audits','state','running or finished');
INSERT INTO schema_description VALUES('audits','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('checkpoint','','One row per job that has not ended and that can go on from a state which its worker has sent.');
INSERT INTO schema_description VALUES('checkpoint','at','When it came, Unix time in milliseconds');
INSERT INTO schema_description VALUES('checkpoint','cycle','Cycle that is the next one');
INSERT INTO schema_description VALUES('checkpoint','job','Number of the job');
INSERT INTO schema_description VALUES('checkpoint','seconds','Time that the computation has taken so far');
INSERT INTO schema_description VALUES('checkpoint','state','Everything that the job needs to go on, with a check sum of its own');
INSERT INTO schema_description VALUES('checkpoint','sweep','The sweep''s key');
INSERT INTO schema_description VALUES('checkpoint','worker','Key of the worker that sent it');
INSERT INTO schema_description VALUES('database','','One row about the database itself.');
INSERT INTO schema_description VALUES('database','created','When it was made, Unix time in milliseconds');
INSERT INTO schema_description VALUES('database','database_id','Random id, 32 hex digits');
INSERT INTO schema_description VALUES('database','epoch','How often a coordinator has opened it');
INSERT INTO schema_description VALUES('database','fingerprint','SHA-256 over the views and descriptions, in hex');
INSERT INTO schema_description VALUES('database','opened','When a coordinator last opened it, Unix time in milliseconds');
INSERT INTO schema_description VALUES('database','row','Always 1');
INSERT INTO schema_description VALUES('database','science_version','Version of the models and operators of all its outcomes');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','','Equilibrium disturbance against mutation size for every combination of operators: all surfaces of chapter 8 at once.');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','acceptance','Whether only changes for the better (or equal) are kept, or occasionally worse ones too; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','criterion','What must not get worse for a change to be kept: each component''s error, or their sum; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','cycles','How many mutations are tried, or candidates evaluated');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','equilibrium_disturbance','How far each time of a disturbed neuron is moved at the start, as a share of the range of 10 steps (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','evolved_total','Average of evolved_total');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','expected_total','Average of expected_total');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','final_total','Average of final_total');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','highest_total','Average of highest_total');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','jobs','Number of jobs averaged');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','mutation','Which child neurons each mutation changes: all, one at random, or those of a random pair of legs; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','mutation_size','The largest uniform step, twice the standard deviation of a normal one, as a share of 10 time steps (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','posture','Whether each evaluation starts from standing or from where the robot stands after the one before; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','steps','How the change of each mutated time is drawn; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','success_rate','Average of success_rate');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('divergence','','One row per result that contradicts the stored one: the same job, another digest.');
INSERT INTO schema_description VALUES('divergence','at','When, Unix time in milliseconds');
INSERT INTO schema_description VALUES('divergence','divergence','Key, in order of time');
INSERT INTO schema_description VALUES('divergence','job','Number of the job');
INSERT INTO schema_description VALUES('divergence','other','Digest of the outcome that contradicts it');
INSERT INTO schema_description VALUES('divergence','stored','Digest of the stored outcome');
INSERT INTO schema_description VALUES('divergence','sweep','The sweep''s key');
INSERT INTO schema_description VALUES('divergence','worker','Key of the worker that delivered the other one');
INSERT INTO schema_description VALUES('event','','The history of the database: what happened, in order.');
INSERT INTO schema_description VALUES('event','at','When, Unix time in milliseconds');
INSERT INTO schema_description VALUES('event','epoch','Epoch of the coordinator that wrote it');
INSERT INTO schema_description VALUES('event','event','Key, in order of time');
INSERT INTO schema_description VALUES('event','job','Number of the job, where it is about one');
INSERT INTO schema_description VALUES('event','kind','What: database_opened, sweep_submitted, worker_joined, lease_lost and the like');
INSERT INTO schema_description VALUES('event','sweep','The sweep''s key, where it is about one');
INSERT INTO schema_description VALUES('event','text','The details, for people');
INSERT INTO schema_description VALUES('event','worker','Key of the worker, where it is about one');
INSERT INTO schema_description VALUES('figure_6_25','','The genetic algorithm of chapter 6: each network under each mutation rate.');
INSERT INTO schema_description VALUES('figure_6_25','criterion','What must not get worse for a change to be kept: each component''s error, or their sum; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_6_25','cycles','How many mutations are tried, or candidates evaluated');
INSERT INTO schema_description VALUES('figure_6_25','evolved_total','Average of evolved_total');
INSERT INTO schema_description VALUES('figure_6_25','expected_total','Average of expected_total');
INSERT INTO schema_description VALUES('figure_6_25','final_total','Average of final_total');
INSERT INTO schema_description VALUES('figure_6_25','highest_total','Average of highest_total');
INSERT INTO schema_description VALUES('figure_6_25','jobs','Number of jobs averaged');
INSERT INTO schema_description VALUES('figure_6_25','mutation_rate','The share of the genes that each mutation draws anew (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_6_25','network','The neural network, or the plain loop, that generates the gait');
INSERT INTO schema_description VALUES('figure_6_25','neuron','The neuron model of a biped''s network; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_6_25','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_6_25','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('figure_6_25','posture','Whether each evaluation starts from standing or from where the robot stands after the one before; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_6_25','success_rate','Average of success_rate');
INSERT INTO schema_description VALUES('figure_6_25','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('figure_6_27','','Mutation rates of the genetic algorithm of chapter 6: the highest totals side by side.');
INSERT INTO schema_description VALUES('figure_6_27','criterion','What must not get worse for a change to be kept: each component''s error, or their sum; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_6_27','cycles','How many mutations are tried, or candidates evaluated');
INSERT INTO schema_description VALUES('figure_6_27','evolved_total','Average of evolved_total');
INSERT INTO schema_description VALUES('figure_6_27','expected_total','Average of expected_total');
INSERT INTO schema_description VALUES('figure_6_27','final_total','Average of final_total');
INSERT INTO schema_description VALUES('figure_6_27','highest_total','Average of highest_total');
INSERT INTO schema_description VALUES('figure_6_27','jobs','Number of jobs averaged');
INSERT INTO schema_description VALUES('figure_6_27','mutation_rate','The share of the genes that each mutation draws anew (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_6_27','network','The neural network, or the plain loop, that generates the gait');
INSERT INTO schema_description VALUES('figure_6_27','neuron','The neuron model of a biped''s network; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_6_27','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_6_27','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('figure_6_27','posture','Whether each evaluation starts from standing or from where the robot stands after the one before; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_6_27','success_rate','Average of success_rate');
INSERT INTO schema_description VALUES('figure_6_27','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('figure_6_30','','The II-RTEA: each network under each mutation rate.');
INSERT INTO schema_description VALUES('figure_6_30','criterion','What must not get worse for a change to be kept: each component''s error, or their sum; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_6_30','cycles','How many mutations are tried, or candidates evaluated');
INSERT INTO schema_description VALUES('figure_6_30','evolved_total','Average of evolved_total');
INSERT INTO schema_description VALUES('figure_6_30','expected_total','Average of expected_total');
INSERT INTO schema_description VALUES('figure_6_30','final_total','Average of final_total');
INSERT INTO schema_description VALUES('figure_6_30','highest_total','Average of highest_total');
INSERT INTO schema_description VALUES('figure_6_30','jobs','Number of jobs averaged');
INSERT INTO schema_description VALUES('figure_6_30','mutation_rate','The share of the genes that each mutation draws anew (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_6_30','network','The neural network, or the plain loop, that generates the gait');
INSERT INTO schema_description VALUES('figure_6_30','neuron','The neuron model of a biped''s network; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_6_30','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_6_30','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('figure_6_30','posture','Whether each evaluation starts from standing or from where the robot stands after the one before; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_6_30','success_rate','Average of success_rate');
INSERT INTO schema_description VALUES('figure_6_30','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('figure_8_10','','The 1/5 rule under each mutation and acceptance: a chart per row.');
INSERT INTO schema_description VALUES('figure_8_10','acceptance','Whether only changes for the better (or equal) are kept, or occasionally worse ones too; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_10','criterion','What must not get worse for a change to be kept: each component''s error, or their sum; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_10','cycles','How many mutations are tried, or candidates evaluated');
INSERT INTO schema_description VALUES('figure_8_10','evolved_distance','Average of evolved_distance');
INSERT INTO schema_description VALUES('figure_8_10','evolved_fuel','Average of evolved_fuel');
INSERT INTO schema_description VALUES('figure_8_10','evolved_stability','Average of evolved_stability');
INSERT INTO schema_description VALUES('figure_8_10','evolved_total','Average of evolved_total');
INSERT INTO schema_description VALUES('figure_8_10','evolved_weighted_distance','Average of required_distance / 100 × evolved_distance: its share in the total');
INSERT INTO schema_description VALUES('figure_8_10','evolved_weighted_fuel','Average of required_fuel / 100 × evolved_fuel: its share in the total');
INSERT INTO schema_description VALUES('figure_8_10','evolved_weighted_stability','Average of required_stability / 100 × evolved_stability: its share in the total');
INSERT INTO schema_description VALUES('figure_8_10','expected_distance','Average of expected_distance');
INSERT INTO schema_description VALUES('figure_8_10','expected_fuel','Average of expected_fuel');
INSERT INTO schema_description VALUES('figure_8_10','expected_stability','Average of expected_stability');
INSERT INTO schema_description VALUES('figure_8_10','expected_total','Average of expected_total');
INSERT INTO schema_description VALUES('figure_8_10','expected_weighted_distance','Average of required_distance / 100 × expected_distance: its share in the total');
INSERT INTO schema_description VALUES('figure_8_10','expected_weighted_fuel','Average of required_fuel / 100 × expected_fuel: its share in the total');
INSERT INTO schema_description VALUES('figure_8_10','expected_weighted_stability','Average of required_stability / 100 × expected_stability: its share in the total');
INSERT INTO schema_description VALUES('figure_8_10','final_total','Average of final_total');
INSERT INTO schema_description VALUES('figure_8_10','highest_distance','Average of highest_distance');
INSERT INTO schema_description VALUES('figure_8_10','highest_fuel','Average of highest_fuel');
INSERT INTO schema_description VALUES('figure_8_10','highest_stability','Average of highest_stability');
INSERT INTO schema_description VALUES('figure_8_10','highest_total','Average of highest_total');
INSERT INTO schema_description VALUES('figure_8_10','highest_weighted_distance','Average of required_distance / 100 × highest_distance: its share in the total');
INSERT INTO schema_description VALUES('figure_8_10','highest_weighted_fuel','Average of required_fuel / 100 × highest_fuel: its share in the total');
INSERT INTO schema_description VALUES('figure_8_10','highest_weighted_stability','Average of required_stability / 100 × highest_stability: its share in the total');
INSERT INTO schema_description VALUES('figure_8_10','jobs','Number of jobs averaged');
INSERT INTO schema_description VALUES('figure_8_10','mutation','Which child neurons each mutation changes: all, one at random, or those of a random pair of legs; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_10','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_10','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('figure_8_10','posture','Whether each evaluation starts from standing or from where the robot stands after the one before; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_10','success_rate','Average of success_rate');
INSERT INTO schema_description VALUES('figure_8_10','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('figure_8_3','','Normal against uniform distribution when mutating all, under each acceptance: a chart per row.');
INSERT INTO schema_description VALUES('figure_8_3','acceptance','Whether only changes for the better (or equal) are kept, or occasionally worse ones too; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_3','criterion','What must not get worse for a change to be kept: each component''s error, or their sum; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_3','cycles','How many mutations are tried, or candidates evaluated');
INSERT INTO schema_description VALUES('figure_8_3','evolved_distance','Average of evolved_distance');
INSERT INTO schema_description VALUES('figure_8_3','evolved_fuel','Average of evolved_fuel');
INSERT INTO schema_description VALUES('figure_8_3','evolved_stability','Average of evolved_stability');
INSERT INTO schema_description VALUES('figure_8_3','evolved_total','Average of evolved_total');
INSERT INTO schema_description VALUES('figure_8_3','evolved_weighted_distance','Average of required_distance / 100 × evolved_distance: its share in the total');
INSERT INTO schema_description VALUES('figure_8_3','evolved_weighted_fuel','Average of required_fuel / 100 × evolved_fuel: its share in the total');
INSERT INTO schema_description VALUES('figure_8_3','evolved_weighted_stability','Average of required_stability / 100 × evolved_stability: its share in the total');
INSERT INTO schema_description VALUES('figure_8_3','expected_distance','Average of expected_distance');
INSERT INTO schema_description VALUES('figure_8_3','expected_fuel','Average of expected_fuel');
INSERT INTO schema_description VALUES('figure_8_3','expected_stability','Average of expected_stability');
INSERT INTO schema_description VALUES('figure_8_3','expected_total','Average of expected_total');
INSERT INTO schema_description VALUES('figure_8_3','expected_weighted_distance','Average of required_distance / 100 × expected_distance: its share in the total');
INSERT INTO schema_description VALUES('figure_8_3','expected_weighted_fuel','Average of required_fuel / 100 × expected_fuel: its share in the total');
INSERT INTO schema_description VALUES('figure_8_3','expected_weighted_stability','Average of required_stability / 100 × expected_stability: its share in the total');
INSERT INTO schema_description VALUES('figure_8_3','final_total','Average of final_total');
INSERT INTO schema_description VALUES('figure_8_3','highest_distance','Average of highest_distance');
INSERT INTO schema_description VALUES('figure_8_3','highest_fuel','Average of highest_fuel');
INSERT INTO schema_description VALUES('figure_8_3','highest_stability','Average of highest_stability');
INSERT INTO schema_description VALUES('figure_8_3','highest_total','Average of highest_total');
INSERT INTO schema_description VALUES('figure_8_3','highest_weighted_distance','Average of required_distance / 100 × highest_distance: its share in the total');
INSERT INTO schema_description VALUES('figure_8_3','highest_weighted_fuel','Average of required_fuel / 100 × highest_fuel: its share in the total');
INSERT INTO schema_description VALUES('figure_8_3','highest_weighted_stability','Average of required_stability / 100 × highest_stability: its share in the total');
INSERT INTO schema_description VALUES('figure_8_3','jobs','Number of jobs averaged');
INSERT INTO schema_description VALUES('figure_8_3','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_3','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('figure_8_3','posture','Whether each evaluation starts from standing or from where the robot stands after the one before; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_3','steps','How the change of each mutated time is drawn; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_3','success_rate','Average of success_rate');
INSERT INTO schema_description VALUES('figure_8_3','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('figure_8_4','','Normal against uniform distribution when mutating one, under each acceptance: a chart per row.');
INSERT INTO schema_description VALUES('figure_8_4','acceptance','Whether only changes for the better (or equal) are kept, or occasionally worse ones too; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_4','criterion','What must not get worse for a change to be kept: each component''s error, or their sum; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_4','cycles','How many mutations are tried, or candidates evaluated');
INSERT INTO schema_description VALUES('figure_8_4','evolved_distance','Average of evolved_distance');
INSERT INTO schema_description VALUES('figure_8_4','evolved_fuel','Average of evolved_fuel');
INSERT INTO schema_description VALUES('figure_8_4','evolved_stability','Average of evolved_stability');
INSERT INTO schema_description VALUES('figure_8_4','evolved_total','Average of evolved_total');
INSERT INTO schema_description VALUES('figure_8_4','evolved_weighted_distance','Average of required_distance / 100 × evolved_distance: its share in the total');
INSERT INTO schema_description VALUES('figure_8_4','evolved_weighted_fuel','Average of required_fuel / 100 × evolved_fuel: its share in the total');
INSERT INTO schema_description VALUES('figure_8_4','evolved_weighted_stability','Average of required_stability / 100 × evolved_stability: its share in the total');
INSERT INTO schema_description VALUES('figure_8_4','expected_distance','Average of expected_distance');
INSERT INTO schema_description VALUES('figure_8_4','expected_fuel','Average of expected_fuel');
INSERT INTO schema_description VALUES('figure_8_4','expected_stability','Average of expected_stability');
INSERT INTO schema_description VALUES('figure_8_4','expected_total','Average of expected_total');
INSERT INTO schema_description VALUES('figure_8_4','expected_weighted_distance','Average of required_distance / 100 × expected_distance: its share in the total');
INSERT INTO schema_description VALUES('figure_8_4','expected_weighted_fuel','Average of required_fuel / 100 × expected_fuel: its share in the total');
INSERT INTO schema_description VALUES('figure_8_4','expected_weighted_stability','Average of required_stability / 100 × expected_stability: its share in the total');
INSERT INTO schema_description VALUES('figure_8_4','final_total','Average of final_total');
INSERT INTO schema_description VALUES('figure_8_4','highest_distance','Average of highest_distance');
INSERT INTO schema_description VALUES('figure_8_4','highest_fuel','Average of highest_fuel');
INSERT INTO schema_description VALUES('figure_8_4','highest_stability','Average of highest_stability');
INSERT INTO schema_description VALUES('figure_8_4','highest_total','Average of highest_total');
INSERT INTO schema_description VALUES('figure_8_4','highest_weighted_distance','Average of required_distance / 100 × highest_distance: its share in the total');
INSERT INTO schema_description VALUES('figure_8_4','highest_weighted_fuel','Average of required_fuel / 100 × highest_fuel: its share in the total');
INSERT INTO schema_description VALUES('figure_8_4','highest_weighted_stability','Average of required_stability / 100 × highest_stability: its share in the total');
INSERT INTO schema_description VALUES('figure_8_4','jobs','Number of jobs averaged');
INSERT INTO schema_description VALUES('figure_8_4','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_4','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('figure_8_4','posture','Whether each evaluation starts from standing or from where the robot stands after the one before; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_4','steps','How the change of each mutated time is drawn; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_4','success_rate','Average of success_rate');
INSERT INTO schema_description VALUES('figure_8_4','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('figure_8_5','','Normal against uniform distribution when mutating some, under each acceptance: a chart per row.');
INSERT INTO schema_description VALUES('figure_8_5','acceptance','Whether only changes for the better (or equal) are kept, or occasionally worse ones too; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_5','criterion','What must not get worse for a change to be kept: each component''s error, or their sum; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_5','cycles','How many mutations are tried, or candidates evaluated');
INSERT INTO schema_description VALUES('figure_8_5','evolved_distance','Average of evolved_distance');
INSERT INTO schema_description VALUES('figure_8_5','evolved_fuel','Average of evolved_fuel');
INSERT INTO schema_description VALUES('figure_8_5','evolved_stability','Average of evolved_stability');
INSERT INTO schema_description VALUES('figure_8_5','evolved_total','Average of evolved_total');
INSERT INTO schema_description VALUES('figure_8_5','evolved_weighted_distance','Average of required_distance / 100 × evolved_distance: its share in the total');
INSERT INTO schema_description VALUES('figure_8_5','evolved_weighted_fuel','Average of required_fuel / 100 × evolved_fuel: its share in the total');
INSERT INTO schema_description VALUES('figure_8_5','evolved_weighted_stability','Average of required_stability / 100 × evolved_stability: its share in the total');
INSERT INTO schema_description VALUES('figure_8_5','expected_distance','Average of expected_distance');
INSERT INTO schema_description VALUES('figure_8_5','expected_fuel','Average of expected_fuel');
INSERT INTO schema_description VALUES('figure_8_5','expected_stability','Average of expected_stability');
INSERT INTO schema_description VALUES('figure_8_5','expected_total','Average of expected_total');
INSERT INTO schema_description VALUES('figure_8_5','expected_weighted_distance','Average of required_distance / 100 × expected_distance: its share in the total');
INSERT INTO schema_description VALUES('figure_8_5','expected_weighted_fuel','Average of required_fuel / 100 × expected_fuel: its share in the total');
INSERT INTO schema_description VALUES('figure_8_5','expected_weighted_stability','Average of required_stability / 100 × expected_stability: its share in the total');
INSERT INTO schema_description VALUES('figure_8_5','final_total','Average of final_total');
INSERT INTO schema_description VALUES('figure_8_5','highest_distance','Average of highest_distance');
INSERT INTO schema_description VALUES('figure_8_5','highest_fuel','Average of highest_fuel');
INSERT INTO schema_description VALUES('figure_8_5','highest_stability','Average of highest_stability');
INSERT INTO schema_description VALUES('figure_8_5','highest_total','Average of highest_total');
INSERT INTO schema_description VALUES('figure_8_5','highest_weighted_distance','Average of required_distance / 100 × highest_distance: its share in the total');
INSERT INTO schema_description VALUES('figure_8_5','highest_weighted_fuel','Average of required_fuel / 100 × highest_fuel: its share in the total');
INSERT INTO schema_description VALUES('figure_8_5','highest_weighted_stability','Average of required_stability / 100 × highest_stability: its share in the total');
INSERT INTO schema_description VALUES('figure_8_5','jobs','Number of jobs averaged');
INSERT INTO schema_description VALUES('figure_8_5','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_5','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('figure_8_5','posture','Whether each evaluation starts from standing or from where the robot stands after the one before; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_5','steps','How the change of each mutated time is drawn; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_5','success_rate','Average of success_rate');
INSERT INTO schema_description VALUES('figure_8_5','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('figure_8_6','','Equilibrium disturbance against mutation size, normal distribution, simple acceptance: a point of a surface per row.');
INSERT INTO schema_description VALUES('figure_8_6','criterion','What must not get worse for a change to be kept: each component''s error, or their sum; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_6','cycles','How many mutations are tried, or candidates evaluated');
INSERT INTO schema_description VALUES('figure_8_6','equilibrium_disturbance','How far each time of a disturbed neuron is moved at the start, as a share of the range of 10 steps (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_6','evolved_total','Average of evolved_total');
INSERT INTO schema_description VALUES('figure_8_6','expected_total','Average of expected_total');
INSERT INTO schema_description VALUES('figure_8_6','final_total','Average of final_total');
INSERT INTO schema_description VALUES('figure_8_6','highest_total','Average of highest_total');
INSERT INTO schema_description VALUES('figure_8_6','jobs','Number of jobs averaged');
INSERT INTO schema_description VALUES('figure_8_6','mutation','Which child neurons each mutation changes: all, one at random, or those of a random pair of legs; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_6','mutation_size','The largest uniform step, twice the standard deviation of a normal one, as a share of 10 time steps (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_6','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_6','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('figure_8_6','posture','Whether each evaluation starts from standing or from where the robot stands after the one before; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_6','success_rate','Average of success_rate');
INSERT INTO schema_description VALUES('figure_8_6','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('figure_8_7','','Equilibrium disturbance against mutation size, normal distribution, annealing acceptance: a point of a surface per row.');
INSERT INTO schema_description VALUES('figure_8_7','criterion','What must not get worse for a change to be kept: each component''s error, or their sum; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_7','cycles','How many mutations are tried, or candidates evaluated');
INSERT INTO schema_description VALUES('figure_8_7','equilibrium_disturbance','How far each time of a disturbed neuron is moved at the start, as a share of the range of 10 steps (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_7','evolved_total','Average of evolved_total');
INSERT INTO schema_description VALUES('figure_8_7','expected_total','Average of expected_total');
INSERT INTO schema_description VALUES('figure_8_7','final_total','Average of final_total');
INSERT INTO schema_description VALUES('figure_8_7','highest_total','Average of highest_total');
INSERT INTO schema_description VALUES('figure_8_7','jobs','Number of jobs averaged');
INSERT INTO schema_description VALUES('figure_8_7','mutation','Which child neurons each mutation changes: all, one at random, or those of a random pair of legs; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_7','mutation_size','The largest uniform step, twice the standard deviation of a normal one, as a share of 10 time steps (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_7','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_7','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('figure_8_7','posture','Whether each evaluation starts from standing or from where the robot stands after the one before; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_7','success_rate','Average of success_rate');
INSERT INTO schema_description VALUES('figure_8_7','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('figure_8_8','','Equilibrium disturbance against mutation size, uniform distribution, simple acceptance: a point of a surface per row.');
INSERT INTO schema_description VALUES('figure_8_8','criterion','What must not get worse for a change to be kept: each component''s error, or their sum; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_8','cycles','How many mutations are tried, or candidates evaluated');
INSERT INTO schema_description VALUES('figure_8_8','equilibrium_disturbance','How far each time of a disturbed neuron is moved at the start, as a share of the range of 10 steps (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_8','evolved_total','Average of evolved_total');
INSERT INTO schema_description VALUES('figure_8_8','expected_total','Average of expected_total');
INSERT INTO schema_description VALUES('figure_8_8','final_total','Average of final_total');
INSERT INTO schema_description VALUES('figure_8_8','highest_total','Average of highest_total');
INSERT INTO schema_description VALUES('figure_8_8','jobs','Number of jobs averaged');
INSERT INTO schema_description VALUES('figure_8_8','mutation','Which child neurons each mutation changes: all, one at random, or those of a random pair of legs; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_8','mutation_size','The largest uniform step, twice the standard deviation of a normal one, as a share of 10 time steps (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_8','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_8','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('figure_8_8','posture','Whether each evaluation starts from standing or from where the robot stands after the one before; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_8','success_rate','Average of success_rate');
INSERT INTO schema_description VALUES('figure_8_8','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('figure_8_9','','Equilibrium disturbance against mutation size, uniform distribution, annealing acceptance: a point of a surface per row.');
INSERT INTO schema_description VALUES('figure_8_9','criterion','What must not get worse for a change to be kept: each component''s error, or their sum; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_9','cycles','How many mutations are tried, or candidates evaluated');
INSERT INTO schema_description VALUES('figure_8_9','equilibrium_disturbance','How far each time of a disturbed neuron is moved at the start, as a share of the range of 10 steps (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_9','evolved_total','Average of evolved_total');
INSERT INTO schema_description VALUES('figure_8_9','expected_total','Average of expected_total');
INSERT INTO schema_description VALUES('figure_8_9','final_total','Average of final_total');
INSERT INTO schema_description VALUES('figure_8_9','highest_total','Average of highest_total');
INSERT INTO schema_description VALUES('figure_8_9','jobs','Number of jobs averaged');
INSERT INTO schema_description VALUES('figure_8_9','mutation','Which child neurons each mutation changes: all, one at random, or those of a random pair of legs; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_9','mutation_size','The largest uniform step, twice the standard deviation of a normal one, as a share of 10 time steps (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_9','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_9','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('figure_8_9','posture','Whether each evaluation starts from standing or from where the robot stands after the one before; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_9','success_rate','Average of success_rate');
INSERT INTO schema_description VALUES('figure_8_9','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('figure_9_5','','Failures before each change of gait when mutating all: a bar per row.');
INSERT INTO schema_description VALUES('figure_9_5','change','Number of the change within the run, from 0');
INSERT INTO schema_description VALUES('figure_9_5','cycles','How many mutations are tried, or candidates evaluated');
INSERT INTO schema_description VALUES('figure_9_5','failures','Average number of failures before that change');
INSERT INTO schema_description VALUES('figure_9_5','jobs','Number of jobs that have changed their gait so often');
INSERT INTO schema_description VALUES('figure_9_5','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('figure_9_5','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('figure_9_5','tonic_genes','What a change of gait mutates: the tonic input, or the weights as well; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_9_6','','Failures before each change of gait when mutating one: a bar per row.');
INSERT INTO schema_description VALUES('figure_9_6','change','Number of the change within the run, from 0');
INSERT INTO schema_description VALUES('figure_9_6','cycles','How many mutations are tried, or candidates evaluated');
INSERT INTO schema_description VALUES('figure_9_6','failures','Average number of failures before that change');
INSERT INTO schema_description VALUES('figure_9_6','jobs','Number of jobs that have changed their gait so often');
INSERT INTO schema_description VALUES('figure_9_6','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('figure_9_6','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('figure_9_6','tonic_genes','What a change of gait mutates: the tonic input, or the weights as well; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('gait_change','','One row per change of gait in each job of the tonic network.');
INSERT INTO schema_description VALUES('gait_change','change','Number of the change within the run, from 0');
INSERT INTO schema_description VALUES('gait_change','failures','Mutations before that change whose tonic was no other gait''s');
INSERT INTO schema_description VALUES('gait_change','gait_reached','The gait that it changed to: walk, gallop, trot or pace');
INSERT INTO schema_description VALUES('gait_change','job','Number of the job within its sweep, from 0');
INSERT INTO schema_description VALUES('gait_change','mutation','Which child neurons each mutation changes: all, one at random, or those of a random pair of legs; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('gait_change','replicate','Number of its replicate, from 0');
INSERT INTO schema_description VALUES('gait_change','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('gait_change','tonic_genes','What a change of gait mutates: the tonic input, or the weights as well; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('history','','One row per event: what happened, in order.');
INSERT INTO schema_description VALUES('history','at','When, UTC');
INSERT INTO schema_description VALUES('history','epoch','Epoch of the coordinator that wrote it');
INSERT INTO schema_description VALUES('history','event','Number, in order of time');
INSERT INTO schema_description VALUES('history','job','Number of the job, where it is about one');
INSERT INTO schema_description VALUES('history','kind','What: database_opened, sweep_submitted, worker_joined, lease_lost and the like');
INSERT INTO schema_description VALUES('history','sweep','Name of the sweep, where it is about one');
INSERT INTO schema_description VALUES('history','text','The details, for people');
INSERT INTO schema_description VALUES('history','worker','The worker, 16 hex digits, where it is about one');
INSERT INTO schema_description VALUES('job','','One row per job that has ended; jobs that are pending or leased have none. The view result shows it.');
INSERT INTO schema_description VALUES('job','accepted','Mutations kept: the number of rows of the trace');
INSERT INTO schema_description VALUES('job','attempt','Which attempt this is the end of, from 1');
INSERT INTO schema_description VALUES('job','commit_seconds','Time from the arrival of its result to its commit; NULL likewise');
INSERT INTO schema_description VALUES('job','cycles_run','Mutations tried');
INSERT INTO schema_description VALUES('job','digest','SHA-256 over identity and outcome; NULL unless done');
INSERT INTO schema_description VALUES('job','ended','When its row was written, Unix time in milliseconds');
INSERT INTO schema_description VALUES('job','evolved_distance','Distance (eq. 7.7) of the accepted state nearest to the expected fitness');
INSERT INTO schema_description VALUES('job','evolved_fuel','Fuel (eq. 7.9) of the accepted state nearest to the expected fitness');
INSERT INTO schema_description VALUES('job','evolved_stability','Stability (eq. 7.5) of the accepted state nearest to the expected fitness');
INSERT INTO schema_description VALUES('job','evolved_total','Weighted total (eq. 7.4) of the accepted state nearest to the expected fitness');
INSERT INTO schema_description VALUES('job','expected_distance','Distance (eq. 7.7) of the undisturbed gait');
INSERT INTO schema_description VALUES('job','expected_fuel','Fuel (eq. 7.9) of the undisturbed gait');
INSERT INTO schema_description VALUES('job','expected_stability','Stability (eq. 7.5) of the undisturbed gait');
INSERT INTO schema_description VALUES('job','expected_total','Weighted total (eq. 7.4) of the undisturbed gait');
INSERT INTO schema_description VALUES('job','final_distance','Distance (eq. 7.7) of the last accepted state');
INSERT INTO schema_description VALUES('job','final_fuel','Fuel (eq. 7.9) of the last accepted state');
INSERT INTO schema_description VALUES('job','final_stability','Stability (eq. 7.5) of the last accepted state');
INSERT INTO schema_description VALUES('job','final_total','Weighted total (eq. 7.4) of the last accepted state');
INSERT INTO schema_description VALUES('job','highest_distance','Distance (eq. 7.7) of the accepted state with the highest total');
INSERT INTO schema_description VALUES('job','highest_fuel','Fuel (eq. 7.9) of the accepted state with the highest total');
INSERT INTO schema_description VALUES('job','highest_stability','Stability (eq. 7.5) of the accepted state with the highest total');
INSERT INTO schema_description VALUES('job','highest_total','Weighted total (eq. 7.4) of the accepted state with the highest total');
INSERT INTO schema_description VALUES('job','identity','SHA-256 over science version, seed, replicate and canonical parameters');
INSERT INTO schema_description VALUES('job','initial_distance','Distance (eq. 7.7) after the disturbance, before the first mutation');
INSERT INTO schema_description VALUES('job','initial_fuel','Fuel (eq. 7.9) after the disturbance, before the first mutation');
INSERT INTO schema_description VALUES('job','initial_stability','Stability (eq. 7.5) after the disturbance, before the first mutation');
INSERT INTO schema_description VALUES('job','initial_total','Weighted total (eq. 7.4) after the disturbance, before the first mutation');
INSERT INTO schema_description VALUES('job','job','Number of the job within its sweep, from 0');
INSERT INTO schema_description VALUES('job','measures','JSON array of what only some jobs tell, [name, index, value] each; NULL if there is nothing');
INSERT INTO schema_description VALUES('job','parameters','JSON object of the parameters that apply');
INSERT INTO schema_description VALUES('job','queue_seconds','Time from its submission, or from being pending again, to its lease; NULL if none computed it for this sweep');
INSERT INTO schema_description VALUES('job','reason','Why it failed or was quarantined');
INSERT INTO schema_description VALUES('job','replicate','Number of its replicate, from 0');
INSERT INTO schema_description VALUES('job','reused_from_job','Number of the job there');
INSERT INTO schema_description VALUES('job','reused_from_sweep','Key of the sweep whose outcome this is; NULL if it was computed');
INSERT INTO schema_description VALUES('job','seconds','Time that its computation took');
INSERT INTO schema_description VALUES('job','seed','Seed of its random streams; 64 bits, those from 2^63 on appear as negative');
INSERT INTO schema_description VALUES('job','state','done, failed, quarantined or cancelled');
INSERT INTO schema_description VALUES('job','success_rate','Eq. 8.1: successes / cycles_run');
INSERT INTO schema_description VALUES('job','successes','Mutations better than the last accepted state');
INSERT INTO schema_description VALUES('job','sweep','The sweep''s key');
INSERT INTO schema_description VALUES('job','trace','JSON array of the accepted changes, [cycle, stability, distance, fuel, total] each');
INSERT INTO schema_description VALUES('job','waited_seconds','Time that it then waited at its worker; NULL likewise');
INSERT INTO schema_description VALUES('job','worker','Key of the worker that computed it; NULL if none did');
INSERT INTO schema_description VALUES('measure','','One row per number that only some jobs tell; docs/formats/measures.md lists the names.');
INSERT INTO schema_description VALUES('measure','index','Number of the change or cycle that it is about');
INSERT INTO schema_description VALUES('measure','job','Number of the job within its sweep, from 0');
INSERT INTO schema_description VALUES('measure','name','What it is');
INSERT INTO schema_description VALUES('measure','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('measure','value','The number');
INSERT INTO schema_description VALUES('operators','','Every combination of mutation, steps and acceptance: all bar charts of chapter 8 at once.');
INSERT INTO schema_description VALUES('operators','acceptance','Whether only changes for the better (or equal) are kept, or occasionally worse ones too; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('operators','criterion','What must not get worse for a change to be kept: each component''s error, or their sum; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('operators','cycles','How many mutations are tried, or candidates evaluated');
INSERT INTO schema_description VALUES('operators','evolved_distance','Average of evolved_distance');
INSERT INTO schema_description VALUES('operators','evolved_fuel','Average of evolved_fuel');
INSERT INTO schema_description VALUES('operators','evolved_stability','Average of evolved_stability');
INSERT INTO schema_description VALUES('operators','evolved_total','Average of evolved_total');
INSERT INTO schema_description VALUES('operators','evolved_weighted_distance','Average of required_distance / 100 × evolved_distance: its share in the total');
INSERT INTO schema_description VALUES('operators','evolved_weighted_fuel','Average of required_fuel / 100 × evolved_fuel: its share in the total');
INSERT INTO schema_description VALUES('operators','evolved_weighted_stability','Average of required_stability / 100 × evolved_stability: its share in the total');
INSERT INTO schema_description VALUES('operators','expected_distance','Average of expected_distance');
INSERT INTO schema_description VALUES('operators','expected_fuel','Average of expected_fuel');
INSERT INTO schema_description VALUES('operators','expected_stability','Average of expected_stability');
INSERT INTO schema_description VALUES('operators','expected_total','Average of expected_total');
INSERT INTO schema_description VALUES('operators','expected_weighted_distance','Average of required_distance / 100 × expected_distance: its share in the total');
INSERT INTO schema_description VALUES('operators','expected_weighted_fuel','Average of required_fuel / 100 × expected_fuel: its share in the total');
INSERT INTO schema_description VALUES('operators','expected_weighted_stability','Average of required_stability / 100 × expected_stability: its share in the total');
INSERT INTO schema_description VALUES('operators','final_total','Average of final_total');
INSERT INTO schema_description VALUES('operators','highest_distance','Average of highest_distance');
INSERT INTO schema_description VALUES('operators','highest_fuel','Average of highest_fuel');
INSERT INTO schema_description VALUES('operators','highest_stability','Average of highest_stability');
INSERT INTO schema_description VALUES('operators','highest_total','Average of highest_total');
INSERT INTO schema_description VALUES('operators','highest_weighted_distance','Average of required_distance / 100 × highest_distance: its share in the total');
INSERT INTO schema_description VALUES('operators','highest_weighted_fuel','Average of required_fuel / 100 × highest_fuel: its share in the total');
INSERT INTO schema_description VALUES('operators','highest_weighted_stability','Average of required_stability / 100 × highest_stability: its share in the total');
INSERT INTO schema_description VALUES('operators','jobs','Number of jobs averaged');
INSERT INTO schema_description VALUES('operators','mutation','Which child neurons each mutation changes: all, one at random, or those of a random pair of legs; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('operators','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('operators','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('operators','posture','Whether each evaluation starts from standing or from where the robot stands after the one before; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('operators','steps','How the change of each mutated time is drawn; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('operators','success_rate','Average of success_rate');
INSERT INTO schema_description VALUES('operators','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('progress','','One row per sweep: how far it is.');
INSERT INTO schema_description VALUES('progress','archived','1 if it is hidden unless asked for');
INSERT INTO schema_description VALUES('progress','audited','Jobs that audits have computed again');
INSERT INTO schema_description VALUES('progress','cancelled','Jobs that were cancelled');
INSERT INTO schema_description VALUES('progress','divergences','Results that contradicted the stored ones');
INSERT INTO schema_description VALUES('progress','done','Jobs that have an outcome');
INSERT INTO schema_description VALUES('progress','ended','When it was finished or cancelled, UTC; NULL before');
INSERT INTO schema_description VALUES('progress','failed','Jobs that ended without one');
INSERT INTO schema_description VALUES('progress','jobs','Number of its jobs');
INSERT INTO schema_description VALUES('progress','jobs_per_second','Ended jobs per second from submission to the latest result, pauses included and reused ones not; NULL before the first');
INSERT INTO schema_description VALUES('progress','pending','Jobs that have not ended, leased ones included');
INSERT INTO schema_description VALUES('progress','quarantined','Jobs given up after a number of attempts');
INSERT INTO schema_description VALUES('progress','reason','Why it was paused or stopped, where that was not a person''s wish');
INSERT INTO schema_description VALUES('progress','reused','Of the done ones: those whose outcome the database had already');
INSERT INTO schema_description VALUES('progress','seconds_left','Time that the pending jobs need at that rate; NULL if it isn''t known');
INSERT INTO schema_description VALUES('progress','state','running, paused, finished, cancelling, cancelled or deleting');
INSERT INTO schema_description VALUES('progress','submitted','When it was submitted, UTC');
INSERT INTO schema_description VALUES('progress','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('provenance','','One row per job that has ended: where its outcome comes from.');
INSERT INTO schema_description VALUES('provenance','attempt','Which attempt this is the end of, from 1');
INSERT INTO schema_description VALUES('provenance','build','Version and commit that it was built from');
INSERT INTO schema_description VALUES('provenance','commit_seconds','Time from the arrival of its result to its commit');
INSERT INTO schema_description VALUES('provenance','dds','DDS implementation that it used');
INSERT INTO schema_description VALUES('provenance','ended','When its row was written, UTC');
INSERT INTO schema_description VALUES('provenance','flags','Compiler and flags of its build; NULL if unknown');
INSERT INTO schema_description VALUES('provenance','host','Name of that worker''s host');
INSERT INTO schema_description VALUES('provenance','instruction_set','Instruction set that it computed with; NULL if unknown');
INSERT INTO schema_description VALUES('provenance','job','Number of the job within its sweep, from 0');
INSERT INTO schema_description VALUES('provenance','process','Its process id there');
INSERT INTO schema_description VALUES('provenance','processor','Name of its processor; NULL if unknown');
INSERT INTO schema_description VALUES('provenance','queue_seconds','Time from submission, or from being pending again, to lease');
INSERT INTO schema_description VALUES('provenance','reused_from','Sweep and job whose outcome this is, with a slash between; NULL if it was computed for this one');
INSERT INTO schema_description VALUES('provenance','seconds','Time that its computation took');
INSERT INTO schema_description VALUES('provenance','state','done, failed, quarantined or cancelled');
INSERT INTO schema_description VALUES('provenance','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('provenance','waited_seconds','Time that it then waited at its worker');
INSERT INTO schema_description VALUES('provenance','worker','The worker that computed it, 16 hex digits; NULL if none did');
INSERT INTO schema_description VALUES('recovery','','One row per change of the environment in each job: whether and how soon it recovered.');
INSERT INTO schema_description VALUES('recovery','acceptance','Whether only changes for the better (or equal) are kept, or occasionally worse ones too; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('recovery','change','Number of the change within the run, from 0');
INSERT INTO schema_description VALUES('recovery','criterion','What must not get worse for a change to be kept: each component''s error, or their sum; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('recovery','environment_expected_total','Total of the undisturbed gait in the new environment');
INSERT INTO schema_description VALUES('recovery','job','Number of the job within its sweep, from 0');
INSERT INTO schema_description VALUES('recovery','mutation','Which child neurons each mutation changes: all, one at random, or those of a random pair of legs; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('recovery','recovered','1 if an accepted total has come within 5 % of that before the next change, else 0');
INSERT INTO schema_description VALUES('recovery','recovery_cycles','Cycles from the change until then; NULL if it has not recovered');
INSERT INTO schema_description VALUES('recovery','replicate','Number of its replicate, from 0');
INSERT INTO schema_description VALUES('recovery','steps','How the change of each mutated time is drawn; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('recovery','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('result','','One row per job that has ended, with one column per parameter.');
INSERT INTO schema_description VALUES('result','acceptance','Whether only changes for the better (or equal) are kept, or occasionally worse ones too; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','actuator','How outputs move servos: one position per step, or through leaky integrator, reflex and servo');
INSERT INTO schema_description VALUES('result','actuator_stroke','How far from standing an unending pulse sends a servo (positions); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','attempt','Which attempt this is the end of, from 1');
INSERT INTO schema_description VALUES('result','blend_alpha','How far beyond its parents a child may lie, as a share of their distance; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','cooling','The factor on the temperature after every cycle; 1 keeps it constant; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','criterion','What must not get worse for a change to be kept: each component''s error, or their sum; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','crossover','How two parents mix; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','cycles','How many mutations are tried, or candidates evaluated');
INSERT INTO schema_description VALUES('result','delay_refirings','Whether the delay before firing delays each firing or only a neuron''s first; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','digest','SHA-256 over the job''s identity and outcome, 64 hex digits; NULL unless done');
INSERT INTO schema_description VALUES('result','environment','At which cycles the weights of the fitness and the ground change, and to what; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','equilibrium_disturbance','How far each time of a disturbed neuron is moved at the start, as a share of the range of 10 steps (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','evolved_distance','Distance (eq. 7.7) of the accepted state nearest to the expected fitness');
INSERT INTO schema_description VALUES('result','evolved_fuel','Fuel (eq. 7.9) of the accepted state nearest to the expected fitness');
INSERT INTO schema_description VALUES('result','evolved_stability','Stability (eq. 7.5) of the accepted state nearest to the expected fitness');
INSERT INTO schema_description VALUES('result','evolved_total','Weighted total (eq. 7.4) of the accepted state nearest to the expected fitness');
INSERT INTO schema_description VALUES('result','expected_distance','Distance (eq. 7.7) of the undisturbed gait');
INSERT INTO schema_description VALUES('result','expected_fuel','Fuel (eq. 7.9) of the undisturbed gait');
INSERT INTO schema_description VALUES('result','expected_stability','Stability (eq. 7.5) of the undisturbed gait');
INSERT INTO schema_description VALUES('result','expected_total','Weighted total (eq. 7.4) of the undisturbed gait');
INSERT INTO schema_description VALUES('result','final_distance','Distance (eq. 7.7) of the last accepted state');
INSERT INTO schema_description VALUES('result','final_fuel','Fuel (eq. 7.9) of the last accepted state');
INSERT INTO schema_description VALUES('result','final_stability','Stability (eq. 7.5) of the last accepted state');
INSERT INTO schema_description VALUES('result','final_total','Weighted total (eq. 7.4) of the last accepted state');
INSERT INTO schema_description VALUES('result','first_standard_deviation','The standard deviation that the 1/5 rule starts with (steps); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','first_step','The standard deviation of the first steps (steps); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','first_temperature','The temperature that the schedule starts with (fitness); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','gait','The gait that the network is preset with and that sets the expected fitness; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','ground_level_back_left','Vertical position at which the back left foot meets the ground (positions); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','ground_level_back_right','Vertical position at which the back right foot meets the ground (positions); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','ground_level_front_left','Vertical position at which the front left foot meets the ground (positions); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','ground_level_front_right','Vertical position at which the front right foot meets the ground (positions); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','highest_distance','Distance (eq. 7.7) of the accepted state with the highest total');
INSERT INTO schema_description VALUES('result','highest_fuel','Fuel (eq. 7.9) of the accepted state with the highest total');
INSERT INTO schema_description VALUES('result','highest_stability','Stability (eq. 7.5) of the accepted state with the highest total');
INSERT INTO schema_description VALUES('result','highest_total','Weighted total (eq. 7.4) of the accepted state with the highest total');
INSERT INTO schema_description VALUES('result','hybrid_share','The share of the evaluations that the genetic algorithm has before refinement (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','initial_distance','Distance (eq. 7.7) after the disturbance, before the first mutation');
INSERT INTO schema_description VALUES('result','initial_fuel','Fuel (eq. 7.9) after the disturbance, before the first mutation');
INSERT INTO schema_description VALUES('result','initial_stability','Stability (eq. 7.5) after the disturbance, before the first mutation');
INSERT INTO schema_description VALUES('result','initial_total','Weighted total (eq. 7.4) after the disturbance, before the first mutation');
INSERT INTO schema_description VALUES('result','integrator_time_constant','The time constant of the leaky integrator (steps); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','job','Number of the job within its sweep, from 0');
INSERT INTO schema_description VALUES('result','maximum_standard_deviation','The largest standard deviation that the 1/5 rule goes up to (steps); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','minimum_standard_deviation','The smallest standard deviation that the 1/5 rule goes down to (steps); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','mutation','Which child neurons each mutation changes: all, one at random, or those of a random pair of legs; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','mutation_rate','The share of the genes that each mutation draws anew (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','mutation_size','The largest uniform step, twice the standard deviation of a normal one, as a share of 10 time steps (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','network','The neural network, or the plain loop, that generates the gait');
INSERT INTO schema_description VALUES('result','neuron','The neuron model of a biped''s network; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','offspring','How many children a generation has, λ (members); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','population','How many members the population has; of an evolution strategy: parents (members); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','posture','Whether each evaluation starts from standing or from where the robot stands after the one before; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','push_factor','How hard a push on the ground drives the body; 1 on flat ground; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','record','What is kept besides scores: accepted changes, or also how far the genes moved and De Jong''s on-line and off-line performance');
INSERT INTO schema_description VALUES('result','reflex_damping','The damping of the reflex by the speed (1/steps); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','reflex_gain','The gain of the reflex on the error of the position (1/steps²); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','repeatability','bitwise: any machine computes the same bits again; same_build: only the same build does; NULL unless done');
INSERT INTO schema_description VALUES('result','replicate','Number of its replicate, from 0');
INSERT INTO schema_description VALUES('result','required_distance','The weight of distance in the fitness (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','required_fuel','The weight of the fuel that remains in the fitness (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','required_stability','The weight of stability in the fitness (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','robot','The robot that is controlled');
INSERT INTO schema_description VALUES('result','seconds','Time that its computation took; not deterministic');
INSERT INTO schema_description VALUES('result','seed','Seed of its random streams; decimal text from 2^63 on');
INSERT INTO schema_description VALUES('result','selection','How parents are chosen; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','standard_deviation_factor','What the 1/5 rule multiplies the standard deviation by to shrink it, and divides it by to widen it; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','state','done, failed, quarantined or cancelled');
INSERT INTO schema_description VALUES('result','step_variance','Whether the variance of normal steps is constant or is multiplied by the square root of the error; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','steps','How the change of each mutated time is drawn; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','strategy','Which evolution strategy; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','success_rate','Eq. 8.1: successes / cycles');
INSERT INTO schema_description VALUES('result','success_window','How many mutations the 1/5 rule counts successes over before it adapts (mutations); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('result','system_disturbance','The share of the neurons that is disturbed at the start; where it does not apply all are (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','temperature','The temperature that scales how much worse a change may be and still be kept (fitness); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','temperature_factor','The factor on the temperature after every evaluation; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','time_steps','The length of one evaluation of the robot (steps)');
INSERT INTO schema_description VALUES('result','tonic_genes','What a change of gait mutates: the tonic input, or the weights as well; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','tournament_size','How many members compete for being a parent (members); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','trainer','What tunes the genes');
INSERT INTO schema_description VALUES('result','weight_range','Which weights a pair of neurons evolves: from 0 to 1 as printed, or from -1 to 1; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','worker','The worker that computed it, 16 hex digits; NULL if none did');
INSERT INTO schema_description VALUES('schema_description','','What every table, view and column means.');
INSERT INTO schema_description VALUES('schema_description','column','Name of the column; empty for the object itself');
INSERT INTO schema_description VALUES('schema_description','description','What it means');
INSERT INTO schema_description VALUES('schema_description','object','Name of the table or view');
INSERT INTO schema_description VALUES('schema_version','','One row per version that the tables have had.');
INSERT INTO schema_description VALUES('schema_version','applied','Since when, Unix time in milliseconds');
INSERT INTO schema_description VALUES('schema_version','program','Version of Lamprey that made them');
INSERT INTO schema_description VALUES('schema_version','version','Version of the tables; the highest is PRAGMA user_version');
INSERT INTO schema_description VALUES('sweep','','One row per submitted sweep.');
INSERT INTO schema_description VALUES('sweep','archived','1 if it is hidden unless asked for');
INSERT INTO schema_description VALUES('sweep','audited','Number of its jobs that audits have computed again');
INSERT INTO schema_description VALUES('sweep','cancelled','Number of its jobs in state cancelled');
INSERT INTO schema_description VALUES('sweep','checksum','SHA-256 over id, name, specification, source, seed, replicates, jobs, science_version, fresh and execution');
INSERT INTO schema_description VALUES('sweep','created','When it was submitted, Unix time in milliseconds');
INSERT INTO schema_description VALUES('sweep','divergences','Number of its rows in divergence');
INSERT INTO schema_description VALUES('sweep','done','Number of its jobs in state done');
INSERT INTO schema_description VALUES('sweep','ended','When it was finished or cancelled, Unix time in milliseconds; NULL before');
INSERT INTO schema_description VALUES('sweep','execution','Protobuf message lamprey.idl.Execution: how it is run; changes no outcome');
INSERT INTO schema_description VALUES('sweep','failed','Number of its jobs in state failed');
INSERT INTO schema_description VALUES('sweep','fresh','1 if every job is computed, also those whose outcome the database has');
INSERT INTO schema_description VALUES('sweep','id','Id, 32 hex digits, from the canonical specification');
INSERT INTO schema_description VALUES('sweep','jobs','Number of jobs: cells of all grids times replicates');
INSERT INTO schema_description VALUES('sweep','last_result','When its latest job ended, Unix time in milliseconds; NULL before the first');
INSERT INTO schema_description VALUES('sweep','name','Name given in the sweep file, or later');
INSERT INTO schema_description VALUES('sweep','quarantined','Number of its jobs in state quarantined');
INSERT INTO schema_description VALUES('sweep','reason','Why it was paused or stopped, where that was not a person''s wish');
INSERT INTO schema_description VALUES('sweep','replicates','Number of replicates of each cell of the grid');
INSERT INTO schema_description VALUES('sweep','reused','Number of its jobs whose outcome was another sweep''s');
INSERT INTO schema_description VALUES('sweep','science_version','Version of the models and operators that it runs under');
INSERT INTO schema_description VALUES('sweep','seed','Seed of all its jobs; 64 bits, those from 2^63 on appear as negative');
INSERT INTO schema_description VALUES('sweep','source','The sweep file as its author wrote it; may be empty');
INSERT INTO schema_description VALUES('sweep','specification','Protobuf message lamprey.idl.SweepSpecification');
INSERT INTO schema_description VALUES('sweep','state','running, paused, finished, cancelling, cancelled or deleting');
INSERT INTO schema_description VALUES('sweep','sweep','Key, in order of submission');
INSERT INTO schema_description VALUES('trace','','One row per accepted change of each job. Ask for one sweep and few jobs: a large sweep has millions of rows.');
INSERT INTO schema_description VALUES('trace','cycle','Cycle whose mutation was accepted, from 0');
INSERT INTO schema_description VALUES('trace','distance','Distance (eq. 7.7) after it');
INSERT INTO schema_description VALUES('trace','fuel','Fuel (eq. 7.9) after it');
INSERT INTO schema_description VALUES('trace','job','Number of the job within its sweep, from 0');
INSERT INTO schema_description VALUES('trace','stability','Stability (eq. 7.5) after it');
INSERT INTO schema_description VALUES('trace','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('trace','total','Weighted total (eq. 7.4) after it');
INSERT INTO schema_description VALUES('variation','','One row per accepted change of each job with record: details: how far the genes have moved, and the fitness.');
INSERT INTO schema_description VALUES('variation','cycle','Cycle whose mutation was accepted, from 0');
INSERT INTO schema_description VALUES('variation','job','Number of the job within its sweep, from 0');
INSERT INTO schema_description VALUES('variation','parameter_variation','Mean over the genes of how far each is from its first value');
INSERT INTO schema_description VALUES('variation','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('variation','total','Weighted total (eq. 7.4) after it');
INSERT INTO schema_description VALUES('worker','','One row per run of a worker process that has joined.');
INSERT INTO schema_description VALUES('worker','build','Version and commit that it was built from');
INSERT INTO schema_description VALUES('worker','dds','DDS implementation that it used');
INSERT INTO schema_description VALUES('worker','draining','1 if it was told to take nothing more and has not left since');
INSERT INTO schema_description VALUES('worker','first_seen','When it first appeared, Unix time in milliseconds');
INSERT INTO schema_description VALUES('worker','flags','Compiler and flags of its build; empty if unknown');
INSERT INTO schema_description VALUES('worker','host','Name of its host');
INSERT INTO schema_description VALUES('worker','instruction_set','Instruction set that it computed with; empty if unknown');
INSERT INTO schema_description VALUES('worker','labels','Its labels, between commas');
INSERT INTO schema_description VALUES('worker','last_seen','When this row was last brought up to date, Unix time in milliseconds');
INSERT INTO schema_description VALUES('worker','process','Its process id there');
INSERT INTO schema_description VALUES('worker','processor','Name of its processor; empty if unknown');
INSERT INTO schema_description VALUES('worker','threads','Number of its computing threads');
INSERT INTO schema_description VALUES('worker','worker','Key: the worker''s incarnation, 64 bits; printf(''%016x'', worker) in logs');
DELETE FROM sqlite_sequence;
INSERT INTO sqlite_sequence VALUES('sweep',3);
CREATE VIEW "attempts" AS SELECT
  s.name AS "sweep",
  a.job AS "job",
  strftime('%Y-%m-%dT%H:%M:%SZ', a.at / 1000, 'unixepoch') AS "ended",
  CAST(CASE WHEN a.worker IS NOT NULL THEN printf('%016x', a.worker) END AS TEXT) AS "worker",
  a.ending AS "ending",
  a.counted AS "counted",
  nullif(a.reason, '') AS "reason"
FROM attempt AS a JOIN sweep AS s ON s.sweep = a.sweep;
CREATE VIEW "audits" AS SELECT
  s.name AS "sweep",
  a.id AS "audit",
  a.share AS "share",
  a.jobs AS "jobs",
  a.agreed AS "agreed",
  a.diverged AS "diverged",
  CASE WHEN a.agreed + a.diverged = a.jobs THEN 'finished' ELSE 'running' END AS "state",
  strftime('%Y-%m-%dT%H:%M:%SZ', a.created / 1000, 'unixepoch') AS "started"
FROM audit AS a JOIN sweep AS s ON s.sweep = a.sweep;
CREATE VIEW "disturbance_by_mutation_size" AS SELECT
  s.name AS "sweep",
  CAST(json_extract(j.parameters, '$.mutation') AS TEXT) AS "mutation",
  CAST(json_extract(j.parameters, '$.steps') AS TEXT) AS "steps",
  CAST(json_extract(j.parameters, '$.acceptance') AS TEXT) AS "acceptance",
  CAST(json_extract(j.parameters, '$.equilibrium_disturbance') AS INTEGER) AS "equilibrium_disturbance",
  CAST(json_extract(j.parameters, '$.mutation_size') AS INTEGER) AS "mutation_size",
  CAST(json_extract(j.parameters, '$.objective') AS TEXT) AS "objective",
  CAST(json_extract(j.parameters, '$.criterion') AS TEXT) AS "criterion",
  CAST(json_extract(j.parameters, '$.posture') AS TEXT) AS "posture",
  CAST(json_extract(j.parameters, '$.cycles') AS INTEGER) AS "cycles",
  count(*) AS "jobs",
  avg(j.expected_total) AS "expected_total",
  avg(j.evolved_total) AS "evolved_total",
  avg(j.highest_total) AS "highest_total",
  avg(j.final_total) AS "final_total",
  avg(j.success_rate) AS "success_rate",
  CAST(json_remove(j.parameters, '$.mutation', '$.steps', '$.acceptance', '$.equilibrium_disturbance', '$.mutation_size', '$.system_disturbance', '$.required_stability', '$.required_distance', '$.required_fuel', '$.cycles', '$.objective', '$.criterion', '$.posture') AS TEXT) AS "other_parameters"
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep WHERE j.state = 'done' AND CAST(json_extract(j.parameters, '$.network') AS TEXT) IN ('four_mother') AND CAST(json_extract(j.parameters, '$.trainer') AS TEXT) IN ('rtea')
GROUP BY 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 17;
CREATE VIEW "figure_6_25" AS SELECT
  s.name AS "sweep",
  CAST(json_extract(j.parameters, '$.network') AS TEXT) AS "network",
  CAST(json_extract(j.parameters, '$.neuron') AS TEXT) AS "neuron",
  CAST(json_extract(j.parameters, '$.mutation_rate') AS REAL) AS "mutation_rate",
  CAST(json_extract(j.parameters, '$.objective') AS TEXT) AS "objective",
  CAST(json_extract(j.parameters, '$.criterion') AS TEXT) AS "criterion",
  CAST(json_extract(j.parameters, '$.posture') AS TEXT) AS "posture",
  CAST(json_extract(j.parameters, '$.cycles') AS INTEGER) AS "cycles",
  count(*) AS "jobs",
  avg(j.expected_total) AS "expected_total",
  avg(j.evolved_total) AS "evolved_total",
  avg(j.highest_total) AS "highest_total",
  avg(j.final_total) AS "final_total",
  avg(j.success_rate) AS "success_rate",
  CAST(json_remove(j.parameters, '$.network', '$.neuron', '$.cycles', '$.objective', '$.criterion', '$.posture', '$.mutation_rate') AS TEXT) AS "other_parameters"
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep WHERE j.state = 'done' AND CAST(json_extract(j.parameters, '$.network') AS TEXT) IN ('recurrent_pair', 'feed_forward_pair') AND CAST(json_extract(j.parameters, '$.trainer') AS TEXT) IN ('chapter_6_ga')
GROUP BY 1, 2, 3, 4, 5, 6, 7, 8, 15;
CREATE VIEW "figure_6_27" AS SELECT
  s.name AS "sweep",
  CAST(json_extract(j.parameters, '$.network') AS TEXT) AS "network",
  CAST(json_extract(j.parameters, '$.neuron') AS TEXT) AS "neuron",
  CAST(json_extract(j.parameters, '$.mutation_rate') AS REAL) AS "mutation_rate",
  CAST(json_extract(j.parameters, '$.objective') AS TEXT) AS "objective",
  CAST(json_extract(j.parameters, '$.criterion') AS TEXT) AS "criterion",
  CAST(json_extract(j.parameters, '$.posture') AS TEXT) AS "posture",
  CAST(json_extract(j.parameters, '$.cycles') AS INTEGER) AS "cycles",
  count(*) AS "jobs",
  avg(j.expected_total) AS "expected_total",
  avg(j.evolved_total) AS "evolved_total",
  avg(j.highest_total) AS "highest_total",
  avg(j.final_total) AS "final_total",
  avg(j.success_rate) AS "success_rate",
  CAST(json_remove(j.parameters, '$.network', '$.neuron', '$.cycles', '$.objective', '$.criterion', '$.posture', '$.mutation_rate') AS TEXT) AS "other_parameters"
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep WHERE j.state = 'done' AND CAST(json_extract(j.parameters, '$.network') AS TEXT) IN ('recurrent_pair', 'feed_forward_pair') AND CAST(json_extract(j.parameters, '$.trainer') AS TEXT) IN ('chapter_6_ga')
GROUP BY 1, 2, 3, 4, 5, 6, 7, 8, 15;
CREATE VIEW "figure_6_30" AS SELECT
  s.name AS "sweep",
  CAST(json_extract(j.parameters, '$.network') AS TEXT) AS "network",
  CAST(json_extract(j.parameters, '$.neuron') AS TEXT) AS "neuron",
  CAST(json_extract(j.parameters, '$.mutation_rate') AS REAL) AS "mutation_rate",
  CAST(json_extract(j.parameters, '$.objective') AS TEXT) AS "objective",
  CAST(json_extract(j.parameters, '$.criterion') AS TEXT) AS "criterion",
  CAST(json_extract(j.parameters, '$.posture') AS TEXT) AS "posture",
  CAST(json_extract(j.parameters, '$.cycles') AS INTEGER) AS "cycles",
  count(*) AS "jobs",
  avg(j.expected_total) AS "expected_total",
  avg(j.evolved_total) AS "evolved_total",
  avg(j.highest_total) AS "highest_total",
  avg(j.final_total) AS "final_total",
  avg(j.success_rate) AS "success_rate",
  CAST(json_remove(j.parameters, '$.network', '$.neuron', '$.cycles', '$.objective', '$.criterion', '$.posture', '$.mutation_rate') AS TEXT) AS "other_parameters"
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep WHERE j.state = 'done' AND CAST(json_extract(j.parameters, '$.network') AS TEXT) IN ('recurrent_pair', 'feed_forward_pair') AND CAST(json_extract(j.parameters, '$.trainer') AS TEXT) IN ('ii_rtea')
GROUP BY 1, 2, 3, 4, 5, 6, 7, 8, 15;
CREATE VIEW "figure_8_10" AS SELECT
  s.name AS "sweep",
  CAST(json_extract(j.parameters, '$.mutation') AS TEXT) AS "mutation",
  CAST(json_extract(j.parameters, '$.acceptance') AS TEXT) AS "acceptance",
  CAST(json_extract(j.parameters, '$.objective') AS TEXT) AS "objective",
  CAST(json_extract(j.parameters, '$.criterion') AS TEXT) AS "criterion",
  CAST(json_extract(j.parameters, '$.posture') AS TEXT) AS "posture",
  CAST(json_extract(j.parameters, '$.cycles') AS INTEGER) AS "cycles",
  count(*) AS "jobs",
  avg(j.expected_total) AS "expected_total",
  avg(j.evolved_total) AS "evolved_total",
  avg(j.highest_total) AS "highest_total",
  avg(j.final_total) AS "final_total",
  avg(j.success_rate) AS "success_rate",
  avg(j.expected_stability) AS "expected_stability",
  avg(CAST(json_extract(j.parameters, '$.required_stability') AS INTEGER) * j.expected_stability / 100) AS "expected_weighted_stability",
  avg(j.expected_distance) AS "expected_distance",
  avg(CAST(json_extract(j.parameters, '$.required_distance') AS INTEGER) * j.expected_distance / 100) AS "expected_weighted_distance",
  avg(j.expected_fuel) AS "expected_fuel",
  avg(CAST(json_extract(j.parameters, '$.required_fuel') AS INTEGER) * j.expected_fuel / 100) AS "expected_weighted_fuel",
  avg(j.evolved_stability) AS "evolved_stability",
  avg(CAST(json_extract(j.parameters, '$.required_stability') AS INTEGER) * j.evolved_stability / 100) AS "evolved_weighted_stability",
  avg(j.evolved_distance) AS "evolved_distance",
  avg(CAST(json_extract(j.parameters, '$.required_distance') AS INTEGER) * j.evolved_distance / 100) AS "evolved_weighted_distance",
  avg(j.evolved_fuel) AS "evolved_fuel",
  avg(CAST(json_extract(j.parameters, '$.required_fuel') AS INTEGER) * j.evolved_fuel / 100) AS "evolved_weighted_fuel",
  avg(j.highest_stability) AS "highest_stability",
  avg(CAST(json_extract(j.parameters, '$.required_stability') AS INTEGER) * j.highest_stability / 100) AS "highest_weighted_stability",
  avg(j.highest_distance) AS "highest_distance",
  avg(CAST(json_extract(j.parameters, '$.required_distance') AS INTEGER) * j.highest_distance / 100) AS "highest_weighted_distance",
  avg(j.highest_fuel) AS "highest_fuel",
  avg(CAST(json_extract(j.parameters, '$.required_fuel') AS INTEGER) * j.highest_fuel / 100) AS "highest_weighted_fuel",
  CAST(json_remove(j.parameters, '$.mutation', '$.acceptance', '$.equilibrium_disturbance', '$.mutation_size', '$.system_disturbance', '$.required_stability', '$.required_distance', '$.required_fuel', '$.cycles', '$.objective', '$.criterion', '$.posture') AS TEXT) AS "other_parameters"
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep WHERE j.state = 'done' AND CAST(json_extract(j.parameters, '$.network') AS TEXT) IN ('four_mother') AND CAST(json_extract(j.parameters, '$.trainer') AS TEXT) IN ('rtea') AND CAST(json_extract(j.parameters, '$.steps') AS TEXT) IN ('one_fifth_rule')
GROUP BY 1, 2, 3, 4, 5, 6, 7, 32;
CREATE VIEW "figure_8_3" AS SELECT
  s.name AS "sweep",
  CAST(json_extract(j.parameters, '$.steps') AS TEXT) AS "steps",
  CAST(json_extract(j.parameters, '$.acceptance') AS TEXT) AS "acceptance",
  CAST(json_extract(j.parameters, '$.objective') AS TEXT) AS "objective",
  CAST(json_extract(j.parameters, '$.criterion') AS TEXT) AS "criterion",
  CAST(json_extract(j.parameters, '$.posture') AS TEXT) AS "posture",
  CAST(json_extract(j.parameters, '$.cycles') AS INTEGER) AS "cycles",
  count(*) AS "jobs",
  avg(j.expected_total) AS "expected_total",
  avg(j.evolved_total) AS "evolved_total",
  avg(j.highest_total) AS "highest_total",
  avg(j.final_total) AS "final_total",
  avg(j.success_rate) AS "success_rate",
  avg(j.expected_stability) AS "expected_stability",
  avg(CAST(json_extract(j.parameters, '$.required_stability') AS INTEGER) * j.expected_stability / 100) AS "expected_weighted_stability",
  avg(j.expected_distance) AS "expected_distance",
  avg(CAST(json_extract(j.parameters, '$.required_distance') AS INTEGER) * j.expected_distance / 100) AS "expected_weighted_distance",
  avg(j.expected_fuel) AS "expected_fuel",
  avg(CAST(json_extract(j.parameters, '$.required_fuel') AS INTEGER) * j.expected_fuel / 100) AS "expected_weighted_fuel",
  avg(j.evolved_stability) AS "evolved_stability",
  avg(CAST(json_extract(j.parameters, '$.required_stability') AS INTEGER) * j.evolved_stability / 100) AS "evolved_weighted_stability",
  avg(j.evolved_distance) AS "evolved_distance",
  avg(CAST(json_extract(j.parameters, '$.required_distance') AS INTEGER) * j.evolved_distance / 100) AS "evolved_weighted_distance",
  avg(j.evolved_fuel) AS "evolved_fuel",
  avg(CAST(json_extract(j.parameters, '$.required_fuel') AS INTEGER) * j.evolved_fuel / 100) AS "evolved_weighted_fuel",
  avg(j.highest_stability) AS "highest_stability",
  avg(CAST(json_extract(j.parameters, '$.required_stability') AS INTEGER) * j.highest_stability / 100) AS "highest_weighted_stability",
  avg(j.highest_distance) AS "highest_distance",
  avg(CAST(json_extract(j.parameters, '$.required_distance') AS INTEGER) * j.highest_distance / 100) AS "highest_weighted_distance",
  avg(j.highest_fuel) AS "highest_fuel",
  avg(CAST(json_extract(j.parameters, '$.required_fuel') AS INTEGER) * j.highest_fuel / 100) AS "highest_weighted_fuel",
  CAST(json_remove(j.parameters, '$.steps', '$.acceptance', '$.equilibrium_disturbance', '$.mutation_size', '$.system_disturbance', '$.required_stability', '$.required_distance', '$.required_fuel', '$.cycles', '$.objective', '$.criterion', '$.posture') AS TEXT) AS "other_parameters"
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep WHERE j.state = 'done' AND CAST(json_extract(j.parameters, '$.network') AS TEXT) IN ('four_mother') AND CAST(json_extract(j.parameters, '$.trainer') AS TEXT) IN ('rtea') AND CAST(json_extract(j.parameters, '$.mutation') AS TEXT) IN ('all') AND CAST(json_extract(j.parameters, '$.steps') AS TEXT) IN ('normal', 'uniform')
GROUP BY 1, 2, 3, 4, 5, 6, 7, 32;
CREATE VIEW "figure_8_4" AS SELECT
  s.name AS "sweep",
  CAST(json_extract(j.parameters, '$.steps') AS TEXT) AS "steps",
  CAST(json_extract(j.parameters, '$.acceptance') AS TEXT) AS "acceptance",
  CAST(json_extract(j.parameters, '$.objective') AS TEXT) AS "objective",
  CAST(json_extract(j.parameters, '$.criterion') AS TEXT) AS "criterion",
  CAST(json_extract(j.parameters, '$.posture') AS TEXT) AS "posture",
  CAST(json_extract(j.parameters, '$.cycles') AS INTEGER) AS "cycles",
  count(*) AS "jobs",
  avg(j.expected_total) AS "expected_total",
  avg(j.evolved_total) AS "evolved_total",
  avg(j.highest_total) AS "highest_total",
  avg(j.final_total) AS "final_total",
  avg(j.success_rate) AS "success_rate",
  avg(j.expected_stability) AS "expected_stability",
  avg(CAST(json_extract(j.parameters, '$.required_stability') AS INTEGER) * j.expected_stability / 100) AS "expected_weighted_stability",
  avg(j.expected_distance) AS "expected_distance",
  avg(CAST(json_extract(j.parameters, '$.required_distance') AS INTEGER) * j.expected_distance / 100) AS "expected_weighted_distance",
  avg(j.expected_fuel) AS "expected_fuel",
  avg(CAST(json_extract(j.parameters, '$.required_fuel') AS INTEGER) * j.expected_fuel / 100) AS "expected_weighted_fuel",
  avg(j.evolved_stability) AS "evolved_stability",
  avg(CAST(json_extract(j.parameters, '$.required_stability') AS INTEGER) * j.evolved_stability / 100) AS "evolved_weighted_stability",
  avg(j.evolved_distance) AS "evolved_distance",
  avg(CAST(json_extract(j.parameters, '$.required_distance') AS INTEGER) * j.evolved_distance / 100) AS "evolved_weighted_distance",
  avg(j.evolved_fuel) AS "evolved_fuel",
  avg(CAST(json_extract(j.parameters, '$.required_fuel') AS INTEGER) * j.evolved_fuel / 100) AS "evolved_weighted_fuel",
  avg(j.highest_stability) AS "highest_stability",
  avg(CAST(json_extract(j.parameters, '$.required_stability') AS INTEGER) * j.highest_stability / 100) AS "highest_weighted_stability",
  avg(j.highest_distance) AS "highest_distance",
  avg(CAST(json_extract(j.parameters, '$.required_distance') AS INTEGER) * j.highest_distance / 100) AS "highest_weighted_distance",
  avg(j.highest_fuel) AS "highest_fuel",
  avg(CAST(json_extract(j.parameters, '$.required_fuel') AS INTEGER) * j.highest_fuel / 100) AS "highest_weighted_fuel",
  CAST(json_remove(j.parameters, '$.steps', '$.acceptance', '$.equilibrium_disturbance', '$.mutation_size', '$.system_disturbance', '$.required_stability', '$.required_distance', '$.required_fuel', '$.cycles', '$.objective', '$.criterion', '$.posture') AS TEXT) AS "other_parameters"
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep WHERE j.state = 'done' AND CAST(json_extract(j.parameters, '$.network') AS TEXT) IN ('four_mother') AND CAST(json_extract(j.parameters, '$.trainer') AS TEXT) IN ('rtea') AND CAST(json_extract(j.parameters, '$.mutation') AS TEXT) IN ('one') AND CAST(json_extract(j.parameters, '$.steps') AS TEXT) IN ('normal', 'uniform')
GROUP BY 1, 2, 3, 4, 5, 6, 7, 32;
CREATE VIEW "figure_8_5" AS SELECT
  s.name AS "sweep",
  CAST(json_extract(j.parameters, '$.steps') AS TEXT) AS "steps",
  CAST(json_extract(j.parameters, '$.acceptance') AS TEXT) AS "acceptance",
  CAST(json_extract(j.parameters, '$.objective') AS TEXT) AS "objective",
  CAST(json_extract(j.parameters, '$.criterion') AS TEXT) AS "criterion",
  CAST(json_extract(j.parameters, '$.posture') AS TEXT) AS "posture",
  CAST(json_extract(j.parameters, '$.cycles') AS INTEGER) AS "cycles",
  count(*) AS "jobs",
  avg(j.expected_total) AS "expected_total",
  avg(j.evolved_total) AS "evolved_total",
  avg(j.highest_total) AS "highest_total",
  avg(j.final_total) AS "final_total",
  avg(j.success_rate) AS "success_rate",
  avg(j.expected_stability) AS "expected_stability",
  avg(CAST(json_extract(j.parameters, '$.required_stability') AS INTEGER) * j.expected_stability / 100) AS "expected_weighted_stability",
  avg(j.expected_distance) AS "expected_distance",
  avg(CAST(json_extract(j.parameters, '$.required_distance') AS INTEGER) * j.expected_distance / 100) AS "expected_weighted_distance",
  avg(j.expected_fuel) AS "expected_fuel",
  avg(CAST(json_extract(j.parameters, '$.required_fuel') AS INTEGER) * j.expected_fuel / 100) AS "expected_weighted_fuel",
  avg(j.evolved_stability) AS "evolved_stability",
  avg(CAST(json_extract(j.parameters, '$.required_stability') AS INTEGER) * j.evolved_stability / 100) AS "evolved_weighted_stability",
  avg(j.evolved_distance) AS "evolved_distance",
  avg(CAST(json_extract(j.parameters, '$.required_distance') AS INTEGER) * j.evolved_distance / 100) AS "evolved_weighted_distance",
  avg(j.evolved_fuel) AS "evolved_fuel",
  avg(CAST(json_extract(j.parameters, '$.required_fuel') AS INTEGER) * j.evolved_fuel / 100) AS "evolved_weighted_fuel",
  avg(j.highest_stability) AS "highest_stability",
  avg(CAST(json_extract(j.parameters, '$.required_stability') AS INTEGER) * j.highest_stability / 100) AS "highest_weighted_stability",
  avg(j.highest_distance) AS "highest_distance",
  avg(CAST(json_extract(j.parameters, '$.required_distance') AS INTEGER) * j.highest_distance / 100) AS "highest_weighted_distance",
  avg(j.highest_fuel) AS "highest_fuel",
  avg(CAST(json_extract(j.parameters, '$.required_fuel') AS INTEGER) * j.highest_fuel / 100) AS "highest_weighted_fuel",
  CAST(json_remove(j.parameters, '$.steps', '$.acceptance', '$.equilibrium_disturbance', '$.mutation_size', '$.system_disturbance', '$.required_stability', '$.required_distance', '$.required_fuel', '$.cycles', '$.objective', '$.criterion', '$.posture') AS TEXT) AS "other_parameters"
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep WHERE j.state = 'done' AND CAST(json_extract(j.parameters, '$.network') AS TEXT) IN ('four_mother') AND CAST(json_extract(j.parameters, '$.trainer') AS TEXT) IN ('rtea') AND CAST(json_extract(j.parameters, '$.mutation') AS TEXT) IN ('some') AND CAST(json_extract(j.parameters, '$.steps') AS TEXT) IN ('normal', 'uniform')
GROUP BY 1, 2, 3, 4, 5, 6, 7, 32;
CREATE VIEW "figure_8_6" AS SELECT
  s.name AS "sweep",
  CAST(json_extract(j.parameters, '$.mutation') AS TEXT) AS "mutation",
  CAST(json_extract(j.parameters, '$.equilibrium_disturbance') AS INTEGER) AS "equilibrium_disturbance",
  CAST(json_extract(j.parameters, '$.mutation_size') AS INTEGER) AS "mutation_size",
  CAST(json_extract(j.parameters, '$.objective') AS TEXT) AS "objective",
  CAST(json_extract(j.parameters, '$.criterion') AS TEXT) AS "criterion",
  CAST(json_extract(j.parameters, '$.posture') AS TEXT) AS "posture",
  CAST(json_extract(j.parameters, '$.cycles') AS INTEGER) AS "cycles",
  count(*) AS "jobs",
  avg(j.expected_total) AS "expected_total",
  avg(j.evolved_total) AS "evolved_total",
  avg(j.highest_total) AS "highest_total",
  avg(j.final_total) AS "final_total",
  avg(j.success_rate) AS "success_rate",
  CAST(json_remove(j.parameters, '$.mutation', '$.equilibrium_disturbance', '$.mutation_size', '$.system_disturbance', '$.required_stability', '$.required_distance', '$.required_fuel', '$.cycles', '$.objective', '$.criterion', '$.posture') AS TEXT) AS "other_parameters"
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep WHERE j.state = 'done' AND CAST(json_extract(j.parameters, '$.network') AS TEXT) IN ('four_mother') AND CAST(json_extract(j.parameters, '$.trainer') AS TEXT) IN ('rtea') AND CAST(json_extract(j.parameters, '$.steps') AS TEXT) IN ('normal') AND CAST(json_extract(j.parameters, '$.acceptance') AS TEXT) IN ('simple')
GROUP BY 1, 2, 3, 4, 5, 6, 7, 8, 15;
CREATE VIEW "figure_8_7" AS SELECT
  s.name AS "sweep",
  CAST(json_extract(j.parameters, '$.mutation') AS TEXT) AS "mutation",
  CAST(json_extract(j.parameters, '$.equilibrium_disturbance') AS INTEGER) AS "equilibrium_disturbance",
  CAST(json_extract(j.parameters, '$.mutation_size') AS INTEGER) AS "mutation_size",
  CAST(json_extract(j.parameters, '$.objective') AS TEXT) AS "objective",
  CAST(json_extract(j.parameters, '$.criterion') AS TEXT) AS "criterion",
  CAST(json_extract(j.parameters, '$.posture') AS TEXT) AS "posture",
  CAST(json_extract(j.parameters, '$.cycles') AS INTEGER) AS "cycles",
  count(*) AS "jobs",
  avg(j.expected_total) AS "expected_total",
  avg(j.evolved_total) AS "evolved_total",
  avg(j.highest_total) AS "highest_total",
  avg(j.final_total) AS "final_total",
  avg(j.success_rate) AS "success_rate",
  CAST(json_remove(j.parameters, '$.mutation', '$.equilibrium_disturbance', '$.mutation_size', '$.system_disturbance', '$.required_stability', '$.required_distance', '$.required_fuel', '$.cycles', '$.objective', '$.criterion', '$.posture') AS TEXT) AS "other_parameters"
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep WHERE j.state = 'done' AND CAST(json_extract(j.parameters, '$.network') AS TEXT) IN ('four_mother') AND CAST(json_extract(j.parameters, '$.trainer') AS TEXT) IN ('rtea') AND CAST(json_extract(j.parameters, '$.steps') AS TEXT) IN ('normal') AND CAST(json_extract(j.parameters, '$.acceptance') AS TEXT) IN ('annealing')
GROUP BY 1, 2, 3, 4, 5, 6, 7, 8, 15;
CREATE VIEW "figure_8_8" AS SELECT
  s.name AS "sweep",
  CAST(json_extract(j.parameters, '$.mutation') AS TEXT) AS "mutation",
  CAST(json_extract(j.parameters, '$.equilibrium_disturbance') AS INTEGER) AS "equilibrium_disturbance",
  CAST(json_extract(j.parameters, '$.mutation_size') AS INTEGER) AS "mutation_size",
  CAST(json_extract(j.parameters, '$.objective') AS TEXT) AS "objective",
  CAST(json_extract(j.parameters, '$.criterion') AS TEXT) AS "criterion",
  CAST(json_extract(j.parameters, '$.posture') AS TEXT) AS "posture",
  CAST(json_extract(j.parameters, '$.cycles') AS INTEGER) AS "cycles",
  count(*) AS "jobs",
  avg(j.expected_total) AS "expected_total",
  avg(j.evolved_total) AS "evolved_total",
  avg(j.highest_total) AS "highest_total",
  avg(j.final_total) AS "final_total",
  avg(j.success_rate) AS "success_rate",
  CAST(json_remove(j.parameters, '$.mutation', '$.equilibrium_disturbance', '$.mutation_size', '$.system_disturbance', '$.required_stability', '$.required_distance', '$.required_fuel', '$.cycles', '$.objective', '$.criterion', '$.posture') AS TEXT) AS "other_parameters"
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep WHERE j.state = 'done' AND CAST(json_extract(j.parameters, '$.network') AS TEXT) IN ('four_mother') AND CAST(json_extract(j.parameters, '$.trainer') AS TEXT) IN ('rtea') AND CAST(json_extract(j.parameters, '$.steps') AS TEXT) IN ('uniform') AND CAST(json_extract(j.parameters, '$.acceptance') AS TEXT) IN ('simple')
GROUP BY 1, 2, 3, 4, 5, 6, 7, 8, 15;
CREATE VIEW "figure_8_9" AS SELECT
  s.name AS "sweep",
  CAST(json_extract(j.parameters, '$.mutation') AS TEXT) AS "mutation",
  CAST(json_extract(j.parameters, '$.equilibrium_disturbance') AS INTEGER) AS "equilibrium_disturbance",
  CAST(json_extract(j.parameters, '$.mutation_size') AS INTEGER) AS "mutation_size",
  CAST(json_extract(j.parameters, '$.objective') AS TEXT) AS "objective",
  CAST(json_extract(j.parameters, '$.criterion') AS TEXT) AS "criterion",
  CAST(json_extract(j.parameters, '$.posture') AS TEXT) AS "posture",
  CAST(json_extract(j.parameters, '$.cycles') AS INTEGER) AS "cycles",
  count(*) AS "jobs",
  avg(j.expected_total) AS "expected_total",
  avg(j.evolved_total) AS "evolved_total",
  avg(j.highest_total) AS "highest_total",
  avg(j.final_total) AS "final_total",
  avg(j.success_rate) AS "success_rate",
  CAST(json_remove(j.parameters, '$.mutation', '$.equilibrium_disturbance', '$.mutation_size', '$.system_disturbance', '$.required_stability', '$.required_distance', '$.required_fuel', '$.cycles', '$.objective', '$.criterion', '$.posture') AS TEXT) AS "other_parameters"
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep WHERE j.state = 'done' AND CAST(json_extract(j.parameters, '$.network') AS TEXT) IN ('four_mother') AND CAST(json_extract(j.parameters, '$.trainer') AS TEXT) IN ('rtea') AND CAST(json_extract(j.parameters, '$.steps') AS TEXT) IN ('uniform') AND CAST(json_extract(j.parameters, '$.acceptance') AS TEXT) IN ('annealing')
GROUP BY 1, 2, 3, 4, 5, 6, 7, 8, 15;
CREATE VIEW "figure_9_5" AS SELECT
  s.name AS "sweep",
  CAST(json_extract(j.parameters, '$.tonic_genes') AS TEXT) AS "tonic_genes",
  CAST(json_extract(j.parameters, '$.cycles') AS INTEGER) AS "cycles",
  CAST(json_extract(m.value, '$[1]') AS INTEGER) AS "change",
  count(*) AS "jobs",
  avg(json_extract(m.value, '$[2]')) AS "failures",
  CAST(json_remove(j.parameters, '$.tonic_genes', '$.mutation', '$.cycles') AS TEXT) AS "other_parameters"
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep JOIN json_each(j.measures) AS m WHERE j.state = 'done' AND CAST(json_extract(j.parameters, '$.network') AS TEXT) IN ('tonic') AND CAST(json_extract(j.parameters, '$.mutation') AS TEXT) IN ('all') AND json_extract(m.value, '$[0]') = 'gait_change_failures'
GROUP BY 1, 2, 3, 4, 7;
CREATE VIEW "figure_9_6" AS SELECT
  s.name AS "sweep",
  CAST(json_extract(j.parameters, '$.tonic_genes') AS TEXT) AS "tonic_genes",
  CAST(json_extract(j.parameters, '$.cycles') AS INTEGER) AS "cycles",
  CAST(json_extract(m.value, '$[1]') AS INTEGER) AS "change",
  count(*) AS "jobs",
  avg(json_extract(m.value, '$[2]')) AS "failures",
  CAST(json_remove(j.parameters, '$.tonic_genes', '$.mutation', '$.cycles') AS TEXT) AS "other_parameters"
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep JOIN json_each(j.measures) AS m WHERE j.state = 'done' AND CAST(json_extract(j.parameters, '$.network') AS TEXT) IN ('tonic') AND CAST(json_extract(j.parameters, '$.mutation') AS TEXT) IN ('one') AND json_extract(m.value, '$[0]') = 'gait_change_failures'
GROUP BY 1, 2, 3, 4, 7;
CREATE VIEW "gait_change" AS SELECT
  s.name AS "sweep",
  j.job AS "job",
  j.replicate AS "replicate",
  CAST(json_extract(j.parameters, '$.mutation') AS TEXT) AS "mutation",
  CAST(json_extract(j.parameters, '$.tonic_genes') AS TEXT) AS "tonic_genes",
  CAST(json_extract(m.value, '$[1]') AS INTEGER) AS "change",
  CAST(CASE json_extract(m.value, '$[2]') WHEN 1 THEN 'walk' WHEN 2 THEN 'gallop' WHEN 3 THEN 'trot' WHEN 4 THEN 'pace' END AS TEXT) AS "gait_reached",
  CAST((SELECT json_extract(o.value, '$[2]') FROM json_each(j.measures) AS o WHERE json_extract(o.value, '$[0]') = 'gait_change_failures' AND json_extract(o.value, '$[1]') = json_extract(m.value, '$[1]')) AS INTEGER) AS "failures"
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep JOIN json_each(j.measures) AS m WHERE json_extract(m.value, '$[0]') = 'gait_reached';
CREATE VIEW "history" AS SELECT
  e.event AS "event",
  strftime('%Y-%m-%dT%H:%M:%SZ', e.at / 1000, 'unixepoch') AS "at",
  e.epoch AS "epoch",
  e.kind AS "kind",
  s.name AS "sweep",
  e.job AS "job",
  CAST(CASE WHEN e.worker IS NOT NULL THEN printf('%016x', e.worker) END AS TEXT) AS "worker",
  e.text AS "text"
FROM event AS e LEFT JOIN sweep AS s ON s.sweep = e.sweep;
CREATE VIEW "measure" AS SELECT
  s.name AS "sweep",
  j.job AS "job",
  CAST(json_extract(m.value, '$[0]') AS TEXT) AS "name",
  CAST(json_extract(m.value, '$[1]') AS INTEGER) AS "index",
  CAST(json_extract(m.value, '$[2]') AS REAL) AS "value"
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep JOIN json_each(j.measures) AS m;
CREATE VIEW "operators" AS SELECT
  s.name AS "sweep",
  CAST(json_extract(j.parameters, '$.mutation') AS TEXT) AS "mutation",
  CAST(json_extract(j.parameters, '$.steps') AS TEXT) AS "steps",
  CAST(json_extract(j.parameters, '$.acceptance') AS TEXT) AS "acceptance",
  CAST(json_extract(j.parameters, '$.objective') AS TEXT) AS "objective",
  CAST(json_extract(j.parameters, '$.criterion') AS TEXT) AS "criterion",
  CAST(json_extract(j.parameters, '$.posture') AS TEXT) AS "posture",
  CAST(json_extract(j.parameters, '$.cycles') AS INTEGER) AS "cycles",
  count(*) AS "jobs",
  avg(j.expected_total) AS "expected_total",
  avg(j.evolved_total) AS "evolved_total",
  avg(j.highest_total) AS "highest_total",
  avg(j.final_total) AS "final_total",
  avg(j.success_rate) AS "success_rate",
  avg(j.expected_stability) AS "expected_stability",
  avg(CAST(json_extract(j.parameters, '$.required_stability') AS INTEGER) * j.expected_stability / 100) AS "expected_weighted_stability",
  avg(j.expected_distance) AS "expected_distance",
  avg(CAST(json_extract(j.parameters, '$.required_distance') AS INTEGER) * j.expected_distance / 100) AS "expected_weighted_distance",
  avg(j.expected_fuel) AS "expected_fuel",
  avg(CAST(json_extract(j.parameters, '$.required_fuel') AS INTEGER) * j.expected_fuel / 100) AS "expected_weighted_fuel",
  avg(j.evolved_stability) AS "evolved_stability",
  avg(CAST(json_extract(j.parameters, '$.required_stability') AS INTEGER) * j.evolved_stability / 100) AS "evolved_weighted_stability",
  avg(j.evolved_distance) AS "evolved_distance",
  avg(CAST(json_extract(j.parameters, '$.required_distance') AS INTEGER) * j.evolved_distance / 100) AS "evolved_weighted_distance",
  avg(j.evolved_fuel) AS "evolved_fuel",
  avg(CAST(json_extract(j.parameters, '$.required_fuel') AS INTEGER) * j.evolved_fuel / 100) AS "evolved_weighted_fuel",
  avg(j.highest_stability) AS "highest_stability",
  avg(CAST(json_extract(j.parameters, '$.required_stability') AS INTEGER) * j.highest_stability / 100) AS "highest_weighted_stability",
  avg(j.highest_distance) AS "highest_distance",
  avg(CAST(json_extract(j.parameters, '$.required_distance') AS INTEGER) * j.highest_distance / 100) AS "highest_weighted_distance",
  avg(j.highest_fuel) AS "highest_fuel",
  avg(CAST(json_extract(j.parameters, '$.required_fuel') AS INTEGER) * j.highest_fuel / 100) AS "highest_weighted_fuel",
  CAST(json_remove(j.parameters, '$.mutation', '$.steps', '$.acceptance', '$.equilibrium_disturbance', '$.mutation_size', '$.system_disturbance', '$.required_stability', '$.required_distance', '$.required_fuel', '$.cycles', '$.objective', '$.criterion', '$.posture') AS TEXT) AS "other_parameters"
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep WHERE j.state = 'done' AND CAST(json_extract(j.parameters, '$.network') AS TEXT) IN ('four_mother') AND CAST(json_extract(j.parameters, '$.trainer') AS TEXT) IN ('rtea')
GROUP BY 1, 2, 3, 4, 5, 6, 7, 8, 33;
CREATE VIEW "progress" AS SELECT
  name AS "sweep",
  state AS "state",
  jobs AS "jobs",
  CAST(jobs - (done + failed + quarantined + cancelled) AS INTEGER) AS "pending",
  done AS "done",
  failed AS "failed",
  quarantined AS "quarantined",
  cancelled AS "cancelled",
  divergences AS "divergences",
  reused AS "reused",
  audited AS "audited",
  CAST((1000.0 * ((done + failed + quarantined + cancelled) - reused) / nullif(last_result - created, 0)) AS REAL) AS "jobs_per_second",
  CAST((jobs - (done + failed + quarantined + cancelled)) / nullif((1000.0 * ((done + failed + quarantined + cancelled) - reused) / nullif(last_result - created, 0)), 0) AS REAL) AS "seconds_left",
  strftime('%Y-%m-%dT%H:%M:%SZ', created / 1000, 'unixepoch') AS "submitted",
  strftime('%Y-%m-%dT%H:%M:%SZ', ended / 1000, 'unixepoch') AS "ended",
  archived AS "archived",
  reason AS "reason"
FROM sweep;
CREATE VIEW "provenance" AS SELECT
  s.name AS "sweep",
  j.job AS "job",
  j.state AS "state",
  j.attempt AS "attempt",
  CAST(CASE WHEN j.worker IS NOT NULL THEN printf('%016x', j.worker) END AS TEXT) AS "worker",
  nullif(w.host, '') AS "host",
  w.process AS "process",
  nullif(w.processor, '') AS "processor",
  nullif(w.instruction_set, '') AS "instruction_set",
  nullif(w.build, '') AS "build",
  nullif(w.flags, '') AS "flags",
  nullif(w.dds, '') AS "dds",
  j.queue_seconds AS "queue_seconds",
  j.waited_seconds AS "waited_seconds",
  j.seconds AS "seconds",
  j.commit_seconds AS "commit_seconds",
  strftime('%Y-%m-%dT%H:%M:%SZ', j.ended / 1000, 'unixepoch') AS "ended",
  CASE WHEN j.reused_from_job IS NOT NULL THEN coalesce(r.name, '(deleted)') || '/' || j.reused_from_job END AS "reused_from"
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep LEFT JOIN worker AS w ON w.worker = j.worker LEFT JOIN sweep AS r ON r.sweep = j.reused_from_sweep;
CREATE VIEW "recovery" AS SELECT
  s.name AS "sweep",
  j.job AS "job",
  j.replicate AS "replicate",
  CAST(json_extract(j.parameters, '$.mutation') AS TEXT) AS "mutation",
  CAST(json_extract(j.parameters, '$.steps') AS TEXT) AS "steps",
  CAST(json_extract(j.parameters, '$.acceptance') AS TEXT) AS "acceptance",
  CAST(json_extract(j.parameters, '$.criterion') AS TEXT) AS "criterion",
  CAST(json_extract(m.value, '$[1]') AS INTEGER) AS "change",
  CAST((SELECT json_extract(o.value, '$[2]') FROM json_each(j.measures) AS o WHERE json_extract(o.value, '$[0]') = 'environment_expected_total' AND json_extract(o.value, '$[1]') = json_extract(m.value, '$[1]')) AS REAL) AS "environment_expected_total",
  CAST(json_extract(m.value, '$[2]') AS INTEGER) AS "recovered",
  CAST((SELECT json_extract(o.value, '$[2]') FROM json_each(j.measures) AS o WHERE json_extract(o.value, '$[0]') = 'recovery_cycles' AND json_extract(o.value, '$[1]') = json_extract(m.value, '$[1]')) AS INTEGER) AS "recovery_cycles"
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep JOIN json_each(j.measures) AS m WHERE json_extract(m.value, '$[0]') = 'recovered';
CREATE VIEW "result" AS SELECT
  s.name AS "sweep",
  j.job AS "job",
  j.state AS "state",
  CAST(nullif(lower(hex(j.digest)), '') AS TEXT) AS "digest",
  j.attempt AS "attempt",
  CAST(CASE WHEN j.worker IS NOT NULL THEN printf('%016x', j.worker) END AS TEXT) AS "worker",
  CASE WHEN j.seed < 0 THEN printf('%u', j.seed) ELSE j.seed END AS "seed",
  j.replicate AS "replicate",
  CAST(json_extract(j.parameters, '$.robot') AS TEXT) AS "robot",
  CAST(json_extract(j.parameters, '$.network') AS TEXT) AS "network",
  CAST(json_extract(j.parameters, '$.neuron') AS TEXT) AS "neuron",
  CAST(json_extract(j.parameters, '$.weight_range') AS TEXT) AS "weight_range",
  CAST(json_extract(j.parameters, '$.gait') AS TEXT) AS "gait",
  CAST(json_extract(j.parameters, '$.delay_refirings') AS TEXT) AS "delay_refirings",
  CAST(json_extract(j.parameters, '$.tonic_genes') AS TEXT) AS "tonic_genes",
  CAST(json_extract(j.parameters, '$.actuator') AS TEXT) AS "actuator",
  CAST(json_extract(j.parameters, '$.integrator_time_constant') AS REAL) AS "integrator_time_constant",
  CAST(json_extract(j.parameters, '$.actuator_stroke') AS REAL) AS "actuator_stroke",
  CAST(json_extract(j.parameters, '$.reflex_gain') AS REAL) AS "reflex_gain",
  CAST(json_extract(j.parameters, '$.reflex_damping') AS REAL) AS "reflex_damping",
  CAST(json_extract(j.parameters, '$.trainer') AS TEXT) AS "trainer",
  CAST(json_extract(j.parameters, '$.mutation') AS TEXT) AS "mutation",
  CAST(json_extract(j.parameters, '$.steps') AS TEXT) AS "steps",
  CAST(json_extract(j.parameters, '$.acceptance') AS TEXT) AS "acceptance",
  CAST(json_extract(j.parameters, '$.equilibrium_disturbance') AS INTEGER) AS "equilibrium_disturbance",
  CAST(json_extract(j.parameters, '$.mutation_size') AS INTEGER) AS "mutation_size",
  CAST(json_extract(j.parameters, '$.system_disturbance') AS INTEGER) AS "system_disturbance",
  CAST(json_extract(j.parameters, '$.required_stability') AS INTEGER) AS "required_stability",
  CAST(json_extract(j.parameters, '$.required_distance') AS INTEGER) AS "required_distance",
  CAST(json_extract(j.parameters, '$.required_fuel') AS INTEGER) AS "required_fuel",
  CAST(json_extract(j.parameters, '$.push_factor') AS REAL) AS "push_factor",
  CAST(json_extract(j.parameters, '$.ground_level_front_left') AS INTEGER) AS "ground_level_front_left",
  CAST(json_extract(j.parameters, '$.ground_level_front_right') AS INTEGER) AS "ground_level_front_right",
  CAST(json_extract(j.parameters, '$.ground_level_back_left') AS INTEGER) AS "ground_level_back_left",
  CAST(json_extract(j.parameters, '$.ground_level_back_right') AS INTEGER) AS "ground_level_back_right",
  CAST(json_extract(j.parameters, '$.cycles') AS INTEGER) AS "cycles",
  CAST(json_extract(j.parameters, '$.time_steps') AS INTEGER) AS "time_steps",
  CAST(json_extract(j.parameters, '$.objective') AS TEXT) AS "objective",
  CAST(json_extract(j.parameters, '$.criterion') AS TEXT) AS "criterion",
  CAST(json_extract(j.parameters, '$.posture') AS TEXT) AS "posture",
  CAST(json_extract(j.parameters, '$.environment') AS TEXT) AS "environment",
  CAST(json_extract(j.parameters, '$.record') AS TEXT) AS "record",
  CAST(json_extract(j.parameters, '$.temperature') AS REAL) AS "temperature",
  CAST(json_extract(j.parameters, '$.cooling') AS REAL) AS "cooling",
  CAST(json_extract(j.parameters, '$.step_variance') AS TEXT) AS "step_variance",
  CAST(json_extract(j.parameters, '$.first_standard_deviation') AS REAL) AS "first_standard_deviation",
  CAST(json_extract(j.parameters, '$.success_window') AS INTEGER) AS "success_window",
  CAST(json_extract(j.parameters, '$.standard_deviation_factor') AS REAL) AS "standard_deviation_factor",
  CAST(json_extract(j.parameters, '$.minimum_standard_deviation') AS REAL) AS "minimum_standard_deviation",
  CAST(json_extract(j.parameters, '$.maximum_standard_deviation') AS REAL) AS "maximum_standard_deviation",
  CAST(json_extract(j.parameters, '$.mutation_rate') AS REAL) AS "mutation_rate",
  CAST(json_extract(j.parameters, '$.population') AS INTEGER) AS "population",
  CAST(json_extract(j.parameters, '$.selection') AS TEXT) AS "selection",
  CAST(json_extract(j.parameters, '$.tournament_size') AS INTEGER) AS "tournament_size",
  CAST(json_extract(j.parameters, '$.crossover') AS TEXT) AS "crossover",
  CAST(json_extract(j.parameters, '$.blend_alpha') AS REAL) AS "blend_alpha",
  CAST(json_extract(j.parameters, '$.strategy') AS TEXT) AS "strategy",
  CAST(json_extract(j.parameters, '$.offspring') AS INTEGER) AS "offspring",
  CAST(json_extract(j.parameters, '$.first_step') AS REAL) AS "first_step",
  CAST(json_extract(j.parameters, '$.first_temperature') AS REAL) AS "first_temperature",
  CAST(json_extract(j.parameters, '$.temperature_factor') AS REAL) AS "temperature_factor",
  CAST(json_extract(j.parameters, '$.hybrid_share') AS INTEGER) AS "hybrid_share",
  CAST(j.expected_stability AS REAL) AS "expected_stability",
  CAST(j.expected_distance AS REAL) AS "expected_distance",
  CAST(j.expected_fuel AS REAL) AS "expected_fuel",
  CAST(j.expected_total AS REAL) AS "expected_total",
  CAST(j.initial_stability AS REAL) AS "initial_stability",
  CAST(j.initial_distance AS REAL) AS "initial_distance",
  CAST(j.initial_fuel AS REAL) AS "initial_fuel",
  CAST(j.initial_total AS REAL) AS "initial_total",
  CAST(j.evolved_stability AS REAL) AS "evolved_stability",
  CAST(j.evolved_distance AS REAL) AS "evolved_distance",
  CAST(j.evolved_fuel AS REAL) AS "evolved_fuel",
  CAST(j.evolved_total AS REAL) AS "evolved_total",
  CAST(j.highest_stability AS REAL) AS "highest_stability",
  CAST(j.highest_distance AS REAL) AS "highest_distance",
  CAST(j.highest_fuel AS REAL) AS "highest_fuel",
  CAST(j.highest_total AS REAL) AS "highest_total",
  CAST(j.final_stability AS REAL) AS "final_stability",
  CAST(j.final_distance AS REAL) AS "final_distance",
  CAST(j.final_fuel AS REAL) AS "final_fuel",
  CAST(j.final_total AS REAL) AS "final_total",
  CAST(j.success_rate AS REAL) AS "success_rate",
  j.seconds AS "seconds",
  CAST(CASE WHEN j.state <> 'done' THEN NULL WHEN CAST(json_extract(j.parameters, '$.trainer') AS TEXT) IN ('pagmo_sga', 'pagmo_simulated_annealing', 'pagmo_cmaes') THEN 'same_build' ELSE 'bitwise' END AS TEXT) AS "repeatability"
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep;
CREATE VIEW "trace" AS SELECT
  s.name AS "sweep",
  j.job AS "job",
  CAST(json_extract(t.value, '$[0]') AS INTEGER) AS "cycle",
  CAST(json_extract(t.value, '$[1]') AS REAL) AS "stability",
  CAST(json_extract(t.value, '$[2]') AS REAL) AS "distance",
  CAST(json_extract(t.value, '$[3]') AS REAL) AS "fuel",
  CAST(json_extract(t.value, '$[4]') AS REAL) AS "total"
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep JOIN json_each(j.trace) AS t;
CREATE VIEW "variation" AS SELECT
  s.name AS "sweep",
  j.job AS "job",
  CAST(json_extract(t.value, '$[0]') AS INTEGER) AS "cycle",
  CAST(v.variation AS REAL) AS "parameter_variation",
  CAST(json_extract(t.value, '$[4]') AS REAL) AS "total"
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep CROSS JOIN json_each(j.trace) AS t CROSS JOIN (SELECT j.sweep AS sweep, j.job AS job, json_extract(m.value, '$[1]') AS cycle, json_extract(m.value, '$[2]') AS variation FROM job AS j JOIN json_each(j.measures) AS m WHERE json_extract(m.value, '$[0]') = 'parameter_variation' LIMIT -1) AS v ON v.sweep = j.sweep AND v.job = j.job AND v.cycle = json_extract(t.value, '$[0]')
WHERE j.measures IS NOT NULL;
COMMIT;

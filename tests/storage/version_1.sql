-- A database of schema version 1, as its program left it: sqlite3 .dump, with the header's numbers that it leaves out.
PRAGMA application_id = 1280135250;
PRAGMA user_version = 1;
PRAGMA foreign_keys=OFF;
BEGIN TRANSACTION;
CREATE TABLE IF NOT EXISTS "sweep" (
  "sweep" INTEGER PRIMARY KEY,
  "id" TEXT NOT NULL UNIQUE CHECK (length(id) = 32),
  "name" TEXT NOT NULL UNIQUE,
  "state" TEXT NOT NULL CHECK (state IN ('running', 'finished', 'cancelling', 'cancelled')),
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
  CHECK (done + failed + quarantined + cancelled <= jobs)
);
INSERT INTO sweep VALUES(1,'f7c11747f48884a5332ee2f315d47420','operators','finished',X'0a096f70657261746f727310d60f180222170a1172657175697265645f64697374616e636512020864220c0a066379636c65731202080c22100a0a74696d655f7374657073120208502a5a0a200a086d75746174696f6e12051a03616c6c12051a036f6e6512061a04736f6d650a110a05737465707312081a066e6f726d616c0a230a0a616363657074616e636512081a0673696d706c65120b1a09616e6e65616c696e672a490a110a086d75746174696f6e12051a03616c6c0a190a05737465707312101a0e6f6e655f66696674685f72756c650a190a0a616363657074616e6365120b1a09616e6e65616c696e67',replace('# Every operator once, for a few cycles.\nname: operators\nseed: 2006\nbase: {required_distance: 50, cycles: 6, time_steps: 40}\ngrids:\n  - mutation: [all, one, some]\n    steps: [normal]\n    acceptance: [simple, annealing]\n  - mutation: [all]\n    steps: [one_fifth_rule]\n    acceptance: [annealing]\nreplicates: 2\n','\n',char(10)),2006,2,14,1,X'299a6ea5f377b345129b7dd83a9b402435bc212874b8da5b3a581f91d0820b08',1795344830372,1795344830566,1795344830566,14,0,0,0,0);
INSERT INTO sweep VALUES(2,'1e5f1a69bc5f57b6443052149456cef6','given-up','cancelled',X'0a08676976656e2d757010071801220c0a066379636c6573120208042a1a0a180a0d6d75746174696f6e5f73697a65120208321203089601',replace('name: given-up\nseed: 7\nbase: {cycles: 2}\ngrids:\n  - mutation_size: [25, 75]\n','\n',char(10)),7,1,2,1,X'9ac49c49baf499b6a5115dddf74bb9bf8bcc8d48a99a9ef8307680f33a2b2e46',1795344847787,1795344847827,1795344847827,0,0,0,2,0);
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
  UNIQUE (sweep, job),
  CHECK ((state = 'done') = (digest IS NOT NULL)), CHECK ((state = 'done') = (trace IS NOT NULL)),
  CHECK (state <> 'done' OR (identity IS NOT NULL AND parameters IS NOT NULL))
);
INSERT INTO job VALUES(1,0,'done',X'd03910cf2612ca0f02aef5a6a256148fb147e978f1964e018a0887d43a0c8f4c',X'252c21ab6398e9dc17a2310478b8773b4a957e5c4fa3eb8d135067e270918ebe',1,-8166512274122538008,0.0013595370000000000718,1795344830400,NULL,2006,0,100.0,0.0,92.0,192.0,100.0,-10.0,90.20000000000000284,185.19999999999998863,100.0,-10.0,90.20000000000000284,185.19999999999998863,100.0,-10.0,90.20000000000000284,185.19999999999998863,100.0,-10.0,90.20000000000000284,185.19999999999998863,6,0,0,0.0,'{"robot":"quadruped","network":"four_mother","gait":"walk","mutation":"all","steps":"normal","acceptance":"simple","equilibrium_disturbance":50,"mutation_size":50,"system_disturbance":100,"required_stability":100,"required_distance":50,"required_fuel":100,"cycles":6,"time_steps":40,"objective":"target","criterion":"per_component","posture":"reset","step_variance":"constant"}','[]');
INSERT INTO job VALUES(1,1,'done',X'2cfc611d2f8f72aae6cc631a9538bf45c7285c1f4d9e11dfd03a82768d6db919',X'6e94eaa49ade5357293ee1afb5fc98d08d5a099c08ee82a34878989b9d27290e',1,-8166512274122538008,2.4686999999999999283e-05,1795344830400,NULL,2006,0,100.0,0.0,92.0,192.0,50.0,0.0,91.400000000000005684,141.40000000000000568,90.0,0.0,84.400000000000005686,174.40000000000000567,90.0,0.0,84.400000000000005686,174.40000000000000567,90.0,0.0,84.400000000000005686,174.40000000000000567,6,1,0,0.0,'{"robot":"quadruped","network":"four_mother","gait":"walk","mutation":"all","steps":"normal","acceptance":"annealing","equilibrium_disturbance":50,"mutation_size":50,"system_disturbance":100,"required_stability":100,"required_distance":50,"required_fuel":100,"cycles":6,"time_steps":40,"objective":"target","criterion":"per_component","posture":"reset","temperature":1,"cooling":1,"step_variance":"constant"}','[[3,90,0,84.4,174.4]]');
INSERT INTO job VALUES(1,2,'done',X'9bad61d214ebadb0cb9f6e81d0db85df9a72503f319e7cfad9c8f0e740ab22d2',X'2ddf91a4591eb3abf00ccbc0ee974633e9bd07ca404dacfb82ce856e490bf26b',1,-8166512274122538008,6.5938000000000004637e-05,1795344830463,NULL,2006,0,100.0,0.0,92.0,192.0,22.5,-2.5,93.099999999999994313,114.34999999999999431,22.5,-2.5,93.0,114.25,22.5,-2.5,93.099999999999994313,114.34999999999999431,22.5,-2.5,93.0,114.25,6,3,1,0.16666666666666665741,'{"robot":"quadruped","network":"four_mother","gait":"walk","mutation":"one","steps":"normal","acceptance":"simple","equilibrium_disturbance":50,"mutation_size":50,"system_disturbance":100,"required_stability":100,"required_distance":50,"required_fuel":100,"cycles":6,"time_steps":40,"objective":"target","criterion":"per_component","posture":"reset","step_variance":"constant"}','[[1,22.5,-2.5,93.1,114.35],[3,22.5,-2.5,93.1,114.35],[4,22.5,-2.5,93,114.25]]');
INSERT INTO job VALUES(1,3,'done',X'4a852698d9a71111528c1054650c87f52b63fd4e4fed07534d004ef01f5b74ee',X'328c4e81f0520a337e39e557009fcf91a3a5c89d7933567d85d6c9d3f930ee87',1,-8166512274122538008,1.9079000000000001475e-05,1795344830463,NULL,2006,0,100.0,0.0,92.0,192.0,10.0,-2.5,93.900000000000005684,102.65000000000000568,17.5,0.0,93.500000000000000003,111.0,17.5,0.0,93.500000000000000003,111.0,17.5,0.0,93.500000000000000003,111.0,6,6,1,0.16666666666666665741,'{"robot":"quadruped","network":"four_mother","gait":"walk","mutation":"one","steps":"normal","acceptance":"annealing","equilibrium_disturbance":50,"mutation_size":50,"system_disturbance":100,"required_stability":100,"required_distance":50,"required_fuel":100,"cycles":6,"time_steps":40,"objective":"target","criterion":"per_component","posture":"reset","temperature":1,"cooling":1,"step_variance":"constant"}','[[0,10,0,94,104],[1,17.5,0,93.5,111],[2,17.5,0,93.5,111],[3,17.5,0,93.5,111],[4,17.5,0,93.5,111],[5,17.5,0,93.5,111]]');
INSERT INTO job VALUES(1,4,'done',X'f3b36187d4cbb4a8e505cecae691c6321957f3072ba7187f1f8f462a7990afcd',X'f7b48b9d265491cfdf1307f866200c4534a774b89fd538a811c950a9916ed231',1,-8166512274122538008,1.8737999999999999149e-05,1795344830463,NULL,2006,0,100.0,0.0,92.0,192.0,42.5,-2.5,92.099999999999994319,133.34999999999999431,45.0,-2.5,91.900000000000005686,135.65000000000000568,45.0,-2.5,91.900000000000005686,135.65000000000000568,45.0,-2.5,91.900000000000005686,135.65000000000000568,6,2,1,0.16666666666666665741,'{"robot":"quadruped","network":"four_mother","gait":"walk","mutation":"some","steps":"normal","acceptance":"simple","equilibrium_disturbance":50,"mutation_size":50,"required_stability":100,"required_distance":50,"required_fuel":100,"cycles":6,"time_steps":40,"objective":"target","criterion":"per_component","posture":"reset","step_variance":"constant"}','[[2,45,-2.5,91.9,135.65],[5,45,-2.5,91.9,135.65]]');
INSERT INTO job VALUES(1,5,'done',X'fb8b035ee1b9495ad031c88297613b01d095d9296e89ac86888b3cf3c4d4ccc7',X'83175c5df7425e04ae2226ead9530c6bb9e8fad41bd176162aadea7374a0463b',1,-8166512274122538008,1.8947999999999998833e-05,1795344830463,NULL,2006,0,100.0,0.0,92.0,192.0,92.5,-2.5,82.200000000000002838,173.44999999999998862,92.5,-2.5,82.200000000000002838,173.44999999999998862,92.5,-2.5,82.200000000000002838,173.44999999999998862,90.0,0.0,81.900000000000005686,171.90000000000000568,6,1,0,0.0,'{"robot":"quadruped","network":"four_mother","gait":"walk","mutation":"some","steps":"normal","acceptance":"annealing","equilibrium_disturbance":50,"mutation_size":50,"required_stability":100,"required_distance":50,"required_fuel":100,"cycles":6,"time_steps":40,"objective":"target","criterion":"per_component","posture":"reset","temperature":1,"cooling":1,"step_variance":"constant"}','[[0,90,0,81.9,171.9]]');
INSERT INTO job VALUES(1,6,'done',X'9db23fa95c8cf562eb2860761640e1985439703f27cfdb98cec802d7dd2c09c8',X'380fc11fdeb790ee0cb8e64edd070193b6078063c8f2262cb1ffb0bd53e93a66',1,-8166512274122538008,2.1713000000000000312e-05,1795344830463,NULL,2006,0,100.0,0.0,92.0,192.0,25.0,-5.0,92.70000000000000284,115.20000000000000284,100.0,0.0,87.0,187.0,100.0,0.0,87.0,187.0,100.0,0.0,87.0,187.0,6,2,1,0.16666666666666665741,'{"robot":"quadruped","network":"four_mother","gait":"walk","mutation":"all","steps":"one_fifth_rule","acceptance":"annealing","equilibrium_disturbance":50,"system_disturbance":100,"required_stability":100,"required_distance":50,"required_fuel":100,"cycles":6,"time_steps":40,"objective":"target","criterion":"per_component","posture":"reset","temperature":1,"cooling":1,"first_standard_deviation":5,"success_window":20,"standard_deviation_factor":0.85,"minimum_standard_deviation":0.3,"maximum_standard_deviation":10}','[[0,97.5,0,85.7,183.2],[5,100,0,87,187]]');
INSERT INTO job VALUES(1,7,'done',X'403563085701b4cdc02f52a2c8dd8977eafd0f43cf32dedf7070a80661d05b8c',X'9b5c8ceb7021fa6c4907ceb4fa8f3066475ba5dda92cf6e485440abab3e4e11f',1,-8166512274122538008,2.002900000000000085e-05,1795344830463,NULL,2006,1,100.0,0.0,92.0,192.0,87.5,-5.0,84.299999999999997157,169.30000000000001137,100.0,-2.5,90.599999999999994313,189.34999999999999431,100.0,-2.5,90.599999999999994313,189.34999999999999431,100.0,-2.5,90.599999999999994313,189.34999999999999431,6,1,1,0.16666666666666665741,'{"robot":"quadruped","network":"four_mother","gait":"walk","mutation":"all","steps":"normal","acceptance":"simple","equilibrium_disturbance":50,"mutation_size":50,"system_disturbance":100,"required_stability":100,"required_distance":50,"required_fuel":100,"cycles":6,"time_steps":40,"objective":"target","criterion":"per_component","posture":"reset","step_variance":"constant"}','[[5,100,-2.5,90.6,189.35]]');
INSERT INTO job VALUES(1,8,'done',X'cdcc57b8bd5d0cb5963bd5a95485262496c4fa5758cf326abc6ca720ecc606df',X'0716ccfd6e750c3b403cc2538135eb83d9124db565dbef768c4b203157def31b',1,-8166512274122538008,1.9879000000000000592e-05,1795344830463,NULL,2006,1,100.0,0.0,92.0,192.0,17.5,-10.0,92.200000000000002838,104.70000000000000284,50.0,-5.0,89.700000000000002838,137.19999999999998863,50.0,-5.0,89.700000000000002838,137.19999999999998863,50.0,-5.0,89.700000000000002838,137.19999999999998863,6,4,0,0.0,'{"robot":"quadruped","network":"four_mother","gait":"walk","mutation":"all","steps":"normal","acceptance":"annealing","equilibrium_disturbance":50,"mutation_size":50,"system_disturbance":100,"required_stability":100,"required_distance":50,"required_fuel":100,"cycles":6,"time_steps":40,"objective":"target","criterion":"per_component","posture":"reset","temperature":1,"cooling":1,"step_variance":"constant"}','[[0,25,-12.5,92.2,110.95],[1,22.5,0,88.9,111.4],[3,45,-7.5,91.4,132.65],[4,50,-5,89.7,137.2]]');
INSERT INTO job VALUES(1,9,'done',X'b31e31a35435e172f9321baf4a123cc1cf01d2cea0444d87de4ecc07e4af367c',X'fd53b819b51e4d58b0b2d4827e1a9342bffaaa37aa158f3c96a6c36e9aea35d1',1,-8166512274122538008,9.566200000000000668e-05,1795344830515,NULL,2006,1,100.0,0.0,92.0,192.0,100.0,0.0,87.799999999999997161,187.80000000000001136,100.0,0.0,88.099999999999994313,188.09999999999999432,100.0,0.0,88.099999999999994313,188.09999999999999432,100.0,0.0,88.099999999999994313,188.09999999999999432,6,4,2,0.33333333333333331482,'{"robot":"quadruped","network":"four_mother","gait":"walk","mutation":"one","steps":"normal","acceptance":"simple","equilibrium_disturbance":50,"mutation_size":50,"system_disturbance":100,"required_stability":100,"required_distance":50,"required_fuel":100,"cycles":6,"time_steps":40,"objective":"target","criterion":"per_component","posture":"reset","step_variance":"constant"}','[[0,100,0,87.8,187.8],[1,100,0,87.9,187.9],[3,100,0,88.1,188.1],[4,100,0,88.1,188.1]]');
INSERT INTO job VALUES(1,10,'done',X'946a3ea29f5bb2ebab4cd34e31dadf84397de1181b23039f5e385dee9fd015dd',X'e9aa0598a7e60069fbd0204dac003b34474dcbf3fdf58f7e330b26cc74318e0c',1,-8166512274122538008,1.343899999999999957e-05,1795344830515,NULL,2006,1,100.0,0.0,92.0,192.0,35.0,-10.0,91.0,121.0,35.0,-10.0,91.0,121.0,35.0,-10.0,91.0,121.0,35.0,-10.0,91.0,121.0,6,3,0,0.0,'{"robot":"quadruped","network":"four_mother","gait":"walk","mutation":"one","steps":"normal","acceptance":"annealing","equilibrium_disturbance":50,"mutation_size":50,"system_disturbance":100,"required_stability":100,"required_distance":50,"required_fuel":100,"cycles":6,"time_steps":40,"objective":"target","criterion":"per_component","posture":"reset","temperature":1,"cooling":1,"step_variance":"constant"}','[[0,35,-10,91,121],[1,35,-10,91,121],[4,35,-10,91,121]]');
INSERT INTO job VALUES(1,11,'done',X'85a7d55bf2b6acd854b9fc2bec25e4050f16cc17ee5edd542ad6e2fe652f5fd8',X'a26985c0adcf9c83f66dd6c44d1ca193a827329f3024933157aa0ed786dc8eec',1,-8166512274122538008,1.3879999999999999244e-05,1795344830515,NULL,2006,1,100.0,0.0,92.0,192.0,40.0,0.0,92.0,132.0,40.0,0.0,92.0,132.0,40.0,0.0,92.0,132.0,40.0,0.0,92.0,132.0,6,1,0,0.0,'{"robot":"quadruped","network":"four_mother","gait":"walk","mutation":"some","steps":"normal","acceptance":"simple","equilibrium_disturbance":50,"mutation_size":50,"required_stability":100,"required_distance":50,"required_fuel":100,"cycles":6,"time_steps":40,"objective":"target","criterion":"per_component","posture":"reset","step_variance":"constant"}','[[1,40,0,92,132]]');
INSERT INTO job VALUES(1,12,'done',X'56963ca93da3c18f22cdf2770e60f58f9f4212a9f9ddaf9ed796ac095c9122ff',X'a5babd9f0b47c91dc3473dc8d782ffd04043c99438369f93d41776f84c01b357',1,-8166512274122538008,5.6944999999999997737e-05,1795344830566,NULL,2006,1,100.0,0.0,92.0,192.0,100.0,0.0,92.200000000000002838,192.19999999999998863,100.0,0.0,92.200000000000002838,192.19999999999998863,100.0,0.0,92.400000000000005687,192.40000000000000568,100.0,0.0,92.400000000000005687,192.40000000000000568,6,2,0,0.0,'{"robot":"quadruped","network":"four_mother","gait":"walk","mutation":"some","steps":"normal","acceptance":"annealing","equilibrium_disturbance":50,"mutation_size":50,"required_stability":100,"required_distance":50,"required_fuel":100,"cycles":6,"time_steps":40,"objective":"target","criterion":"per_component","posture":"reset","temperature":1,"cooling":1,"step_variance":"constant"}','[[4,100,0,91.7,191.7],[5,100,0,92.4,192.4]]');
INSERT INTO job VALUES(1,13,'done',X'b946f6bc3be71e3ba6b2055f11cd573e3d79ce2232e7282acc031201f95b5ed0',X'6a7de73e0f7a6c757dec83a73f04cc7d7795db7050272d9595dd654c77ca17b9',1,-8166512274122538008,1.534299999999999862e-05,1795344830566,NULL,2006,1,100.0,0.0,92.0,192.0,32.5,0.0,91.299999999999997156,123.79999999999999715,40.0,0.0,90.0,130.0,40.0,0.0,90.0,130.0,40.0,0.0,90.0,130.0,6,1,0,0.0,'{"robot":"quadruped","network":"four_mother","gait":"walk","mutation":"all","steps":"one_fifth_rule","acceptance":"annealing","equilibrium_disturbance":50,"system_disturbance":100,"required_stability":100,"required_distance":50,"required_fuel":100,"cycles":6,"time_steps":40,"objective":"target","criterion":"per_component","posture":"reset","temperature":1,"cooling":1,"first_standard_deviation":5,"success_window":20,"standard_deviation_factor":0.85,"minimum_standard_deviation":0.3,"maximum_standard_deviation":10}','[[1,40,0,90,130]]');
INSERT INTO job VALUES(2,0,'cancelled',NULL,NULL,1,NULL,0.0,1795344847827,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
INSERT INTO job VALUES(2,1,'cancelled',NULL,NULL,1,NULL,0.0,1795344847827,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL,NULL);
CREATE TABLE IF NOT EXISTS "worker" (
  "worker" INTEGER PRIMARY KEY,
  "host" TEXT NOT NULL,
  "process" INTEGER NOT NULL,
  "threads" INTEGER NOT NULL,
  "build" TEXT NOT NULL,
  "dds" TEXT NOT NULL,
  "first_seen" INTEGER NOT NULL,
  "last_seen" INTEGER NOT NULL
);
INSERT INTO worker VALUES(-8166512274122538008,'host',9946,1,'0.1.0 (7d7b90c19a41)','cyclonedds',1795344830400,1795344830400);
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
INSERT INTO event VALUES(1,1795344830343,1,'database_opened',NULL,NULL,NULL,'epoch 1');
INSERT INTO event VALUES(2,1795344830372,1,'sweep_submitted',1,NULL,NULL,'operators: 14 jobs');
INSERT INTO event VALUES(3,1795344830400,1,'coordinator_started',NULL,NULL,NULL,'epoch 1, over cyclonedds');
INSERT INTO event VALUES(4,1795344830400,1,'worker_joined',NULL,NULL,-8166512274122538008,'host/9946');
INSERT INTO event VALUES(5,1795344830705,1,'sweep_finished',1,NULL,NULL,'operators');
INSERT INTO event VALUES(6,1795344830705,1,'worker_left',NULL,NULL,-8166512274122538008,'host/9946');
INSERT INTO event VALUES(7,1795344830765,1,'coordinator_stopped',NULL,NULL,NULL,'');
INSERT INTO event VALUES(8,1795344846794,2,'database_opened',NULL,NULL,NULL,'epoch 2');
INSERT INTO event VALUES(9,1795344846854,2,'coordinator_started',NULL,NULL,NULL,'epoch 2, over cyclonedds');
INSERT INTO event VALUES(10,1795344847787,2,'sweep_submitted',2,NULL,NULL,'given-up: 2 jobs');
INSERT INTO event VALUES(11,1795344847827,2,'sweep_cancelling',2,NULL,NULL,'2 jobs');
INSERT INTO event VALUES(12,1795344847834,2,'sweep_cancelled',2,NULL,NULL,'given-up');
INSERT INTO event VALUES(13,1795344847834,2,'coordinator_stopped',NULL,NULL,NULL,'');
CREATE TABLE IF NOT EXISTS "divergence" (
  "divergence" INTEGER PRIMARY KEY,
  "at" INTEGER NOT NULL,
  "sweep" INTEGER NOT NULL REFERENCES sweep,
  "job" INTEGER NOT NULL,
  "stored" BLOB NOT NULL CHECK (length(stored) = 32),
  "other" BLOB NOT NULL CHECK (length(other) = 32),
  "worker" INTEGER
);
CREATE TABLE IF NOT EXISTS "database" (
  "row" INTEGER PRIMARY KEY CHECK (row = 1),
  "database_id" TEXT NOT NULL CHECK (length(database_id) = 32),
  "science_version" INTEGER NOT NULL,
  "epoch" INTEGER NOT NULL,
  "created" INTEGER NOT NULL,
  "opened" INTEGER NOT NULL,
  "fingerprint" TEXT NOT NULL
);
INSERT INTO "database" VALUES(1,'7ab1c89acf819752ae67ef0310a05684',1,2,1795344830321,1795344846794,'f522dda787fe1430e3398afe3a38a32f7b8879cd17662e5393feec0054b6b517');
CREATE TABLE IF NOT EXISTS "schema_version" (
  "version" INTEGER PRIMARY KEY,
  "applied" INTEGER NOT NULL,
  "program" TEXT NOT NULL
);
INSERT INTO schema_version VALUES(1,1795344830321,'0.1.0');
CREATE TABLE IF NOT EXISTS "schema_description" (
  "object" TEXT NOT NULL,
  "column" TEXT NOT NULL,
  "description" TEXT NOT NULL,
  PRIMARY KEY (object, "column")
);
INSERT INTO schema_description VALUES('database','','One row about the database itself.');
INSERT INTO schema_description VALUES('database','created','When it was made, Unix time in milliseconds');
INSERT INTO schema_description VALUES('database','database_id','Random id, 32 hex digits');
INSERT INTO schema_description VALUES('database','epoch','How often a coordinator has opened it');
INSERT INTO schema_description VALUES('database','fingerprint','SHA-256 over the views and descriptions, in hex');
INSERT INTO schema_description VALUES('database','opened','When a coordinator last opened it, Unix time in milliseconds');
INSERT INTO schema_description VALUES('database','row','Always 1');
INSERT INTO schema_description VALUES('database','science_version','Version of the models and operators of all its outcomes');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','','Equilibrium disturbance against mutation size for every combination of operators: all surfaces at once.');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','acceptance','Whether only changes for the better (or equal) are kept, or occasionally worse ones too');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','criterion','What must not get worse for a change to be kept: each component''s error, or their sum');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','cycles','How many mutations are tried');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','equilibrium_disturbance','How far each time of a disturbed neuron is moved at the start, as a share of the range of 10 steps (%)');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','evolved_total','Average of evolved_total');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','expected_total','Average of expected_total');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','final_total','Average of final_total');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','highest_total','Average of highest_total');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','jobs','Number of jobs averaged');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','mutation','Which child neurons each mutation changes: all, one at random, or those of a random pair of legs');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','mutation_size','The largest uniform step, twice the standard deviation of a normal one, as a share of 10 time steps (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','posture','Whether each evaluation starts from standing or from where the robot stands after the one before');
INSERT INTO schema_description VALUES('disturbance_by_mutation_size','steps','How the change of each mutated time is drawn');
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
INSERT INTO schema_description VALUES('figure_8_10','','The 1/5 rule under each mutation and acceptance: a chart per row.');
INSERT INTO schema_description VALUES('figure_8_10','acceptance','Whether only changes for the better (or equal) are kept, or occasionally worse ones too');
INSERT INTO schema_description VALUES('figure_8_10','criterion','What must not get worse for a change to be kept: each component''s error, or their sum');
INSERT INTO schema_description VALUES('figure_8_10','cycles','How many mutations are tried');
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
INSERT INTO schema_description VALUES('figure_8_10','mutation','Which child neurons each mutation changes: all, one at random, or those of a random pair of legs');
INSERT INTO schema_description VALUES('figure_8_10','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had');
INSERT INTO schema_description VALUES('figure_8_10','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('figure_8_10','posture','Whether each evaluation starts from standing or from where the robot stands after the one before');
INSERT INTO schema_description VALUES('figure_8_10','success_rate','Average of success_rate');
INSERT INTO schema_description VALUES('figure_8_10','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('figure_8_3','','Normal against uniform distribution when mutating all, under each acceptance: a chart per row.');
INSERT INTO schema_description VALUES('figure_8_3','acceptance','Whether only changes for the better (or equal) are kept, or occasionally worse ones too');
INSERT INTO schema_description VALUES('figure_8_3','criterion','What must not get worse for a change to be kept: each component''s error, or their sum');
INSERT INTO schema_description VALUES('figure_8_3','cycles','How many mutations are tried');
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
INSERT INTO schema_description VALUES('figure_8_3','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had');
INSERT INTO schema_description VALUES('figure_8_3','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('figure_8_3','posture','Whether each evaluation starts from standing or from where the robot stands after the one before');
INSERT INTO schema_description VALUES('figure_8_3','steps','How the change of each mutated time is drawn');
INSERT INTO schema_description VALUES('figure_8_3','success_rate','Average of success_rate');
INSERT INTO schema_description VALUES('figure_8_3','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('figure_8_4','','Normal against uniform distribution when mutating one, under each acceptance: a chart per row.');
INSERT INTO schema_description VALUES('figure_8_4','acceptance','Whether only changes for the better (or equal) are kept, or occasionally worse ones too');
INSERT INTO schema_description VALUES('figure_8_4','criterion','What must not get worse for a change to be kept: each component''s error, or their sum');
INSERT INTO schema_description VALUES('figure_8_4','cycles','How many mutations are tried');
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
INSERT INTO schema_description VALUES('figure_8_4','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had');
INSERT INTO schema_description VALUES('figure_8_4','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('figure_8_4','posture','Whether each evaluation starts from standing or from where the robot stands after the one before');
INSERT INTO schema_description VALUES('figure_8_4','steps','How the change of each mutated time is drawn');
INSERT INTO schema_description VALUES('figure_8_4','success_rate','Average of success_rate');
INSERT INTO schema_description VALUES('figure_8_4','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('figure_8_5','','Normal against uniform distribution when mutating some, under each acceptance: a chart per row.');
INSERT INTO schema_description VALUES('figure_8_5','acceptance','Whether only changes for the better (or equal) are kept, or occasionally worse ones too');
INSERT INTO schema_description VALUES('figure_8_5','criterion','What must not get worse for a change to be kept: each component''s error, or their sum');
INSERT INTO schema_description VALUES('figure_8_5','cycles','How many mutations are tried');
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
INSERT INTO schema_description VALUES('figure_8_5','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had');
INSERT INTO schema_description VALUES('figure_8_5','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('figure_8_5','posture','Whether each evaluation starts from standing or from where the robot stands after the one before');
INSERT INTO schema_description VALUES('figure_8_5','steps','How the change of each mutated time is drawn');
INSERT INTO schema_description VALUES('figure_8_5','success_rate','Average of success_rate');
INSERT INTO schema_description VALUES('figure_8_5','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('figure_8_6','','Equilibrium disturbance against mutation size, normal distribution, simple acceptance: a point of a surface per row.');
INSERT INTO schema_description VALUES('figure_8_6','criterion','What must not get worse for a change to be kept: each component''s error, or their sum');
INSERT INTO schema_description VALUES('figure_8_6','cycles','How many mutations are tried');
INSERT INTO schema_description VALUES('figure_8_6','equilibrium_disturbance','How far each time of a disturbed neuron is moved at the start, as a share of the range of 10 steps (%)');
INSERT INTO schema_description VALUES('figure_8_6','evolved_total','Average of evolved_total');
INSERT INTO schema_description VALUES('figure_8_6','expected_total','Average of expected_total');
INSERT INTO schema_description VALUES('figure_8_6','final_total','Average of final_total');
INSERT INTO schema_description VALUES('figure_8_6','highest_total','Average of highest_total');
INSERT INTO schema_description VALUES('figure_8_6','jobs','Number of jobs averaged');
INSERT INTO schema_description VALUES('figure_8_6','mutation','Which child neurons each mutation changes: all, one at random, or those of a random pair of legs');
INSERT INTO schema_description VALUES('figure_8_6','mutation_size','The largest uniform step, twice the standard deviation of a normal one, as a share of 10 time steps (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_6','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had');
INSERT INTO schema_description VALUES('figure_8_6','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('figure_8_6','posture','Whether each evaluation starts from standing or from where the robot stands after the one before');
INSERT INTO schema_description VALUES('figure_8_6','success_rate','Average of success_rate');
INSERT INTO schema_description VALUES('figure_8_6','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('figure_8_7','','Equilibrium disturbance against mutation size, normal distribution, annealing acceptance: a point of a surface per row.');
INSERT INTO schema_description VALUES('figure_8_7','criterion','What must not get worse for a change to be kept: each component''s error, or their sum');
INSERT INTO schema_description VALUES('figure_8_7','cycles','How many mutations are tried');
INSERT INTO schema_description VALUES('figure_8_7','equilibrium_disturbance','How far each time of a disturbed neuron is moved at the start, as a share of the range of 10 steps (%)');
INSERT INTO schema_description VALUES('figure_8_7','evolved_total','Average of evolved_total');
INSERT INTO schema_description VALUES('figure_8_7','expected_total','Average of expected_total');
INSERT INTO schema_description VALUES('figure_8_7','final_total','Average of final_total');
INSERT INTO schema_description VALUES('figure_8_7','highest_total','Average of highest_total');
INSERT INTO schema_description VALUES('figure_8_7','jobs','Number of jobs averaged');
INSERT INTO schema_description VALUES('figure_8_7','mutation','Which child neurons each mutation changes: all, one at random, or those of a random pair of legs');
INSERT INTO schema_description VALUES('figure_8_7','mutation_size','The largest uniform step, twice the standard deviation of a normal one, as a share of 10 time steps (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_7','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had');
INSERT INTO schema_description VALUES('figure_8_7','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('figure_8_7','posture','Whether each evaluation starts from standing or from where the robot stands after the one before');
INSERT INTO schema_description VALUES('figure_8_7','success_rate','Average of success_rate');
INSERT INTO schema_description VALUES('figure_8_7','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('figure_8_8','','Equilibrium disturbance against mutation size, uniform distribution, simple acceptance: a point of a surface per row.');
INSERT INTO schema_description VALUES('figure_8_8','criterion','What must not get worse for a change to be kept: each component''s error, or their sum');
INSERT INTO schema_description VALUES('figure_8_8','cycles','How many mutations are tried');
INSERT INTO schema_description VALUES('figure_8_8','equilibrium_disturbance','How far each time of a disturbed neuron is moved at the start, as a share of the range of 10 steps (%)');
INSERT INTO schema_description VALUES('figure_8_8','evolved_total','Average of evolved_total');
INSERT INTO schema_description VALUES('figure_8_8','expected_total','Average of expected_total');
INSERT INTO schema_description VALUES('figure_8_8','final_total','Average of final_total');
INSERT INTO schema_description VALUES('figure_8_8','highest_total','Average of highest_total');
INSERT INTO schema_description VALUES('figure_8_8','jobs','Number of jobs averaged');
INSERT INTO schema_description VALUES('figure_8_8','mutation','Which child neurons each mutation changes: all, one at random, or those of a random pair of legs');
INSERT INTO schema_description VALUES('figure_8_8','mutation_size','The largest uniform step, twice the standard deviation of a normal one, as a share of 10 time steps (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_8','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had');
INSERT INTO schema_description VALUES('figure_8_8','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('figure_8_8','posture','Whether each evaluation starts from standing or from where the robot stands after the one before');
INSERT INTO schema_description VALUES('figure_8_8','success_rate','Average of success_rate');
INSERT INTO schema_description VALUES('figure_8_8','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('figure_8_9','','Equilibrium disturbance against mutation size, uniform distribution, annealing acceptance: a point of a surface per row.');
INSERT INTO schema_description VALUES('figure_8_9','criterion','What must not get worse for a change to be kept: each component''s error, or their sum');
INSERT INTO schema_description VALUES('figure_8_9','cycles','How many mutations are tried');
INSERT INTO schema_description VALUES('figure_8_9','equilibrium_disturbance','How far each time of a disturbed neuron is moved at the start, as a share of the range of 10 steps (%)');
INSERT INTO schema_description VALUES('figure_8_9','evolved_total','Average of evolved_total');
INSERT INTO schema_description VALUES('figure_8_9','expected_total','Average of expected_total');
INSERT INTO schema_description VALUES('figure_8_9','final_total','Average of final_total');
INSERT INTO schema_description VALUES('figure_8_9','highest_total','Average of highest_total');
INSERT INTO schema_description VALUES('figure_8_9','jobs','Number of jobs averaged');
INSERT INTO schema_description VALUES('figure_8_9','mutation','Which child neurons each mutation changes: all, one at random, or those of a random pair of legs');
INSERT INTO schema_description VALUES('figure_8_9','mutation_size','The largest uniform step, twice the standard deviation of a normal one, as a share of 10 time steps (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('figure_8_9','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had');
INSERT INTO schema_description VALUES('figure_8_9','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('figure_8_9','posture','Whether each evaluation starts from standing or from where the robot stands after the one before');
INSERT INTO schema_description VALUES('figure_8_9','success_rate','Average of success_rate');
INSERT INTO schema_description VALUES('figure_8_9','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('job','','One row per job that has ended; jobs that are pending or leased have none. The view result shows it.');
INSERT INTO schema_description VALUES('job','accepted','Mutations kept: the number of rows of the trace');
INSERT INTO schema_description VALUES('job','attempt','Which attempt this is the end of, from 1');
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
INSERT INTO schema_description VALUES('job','parameters','JSON object of the parameters that apply');
INSERT INTO schema_description VALUES('job','reason','Why it failed or was quarantined');
INSERT INTO schema_description VALUES('job','replicate','Number of its replicate, from 0');
INSERT INTO schema_description VALUES('job','seconds','Time that its computation took');
INSERT INTO schema_description VALUES('job','seed','Seed of its random streams; 64 bits, those from 2^63 on appear as negative');
INSERT INTO schema_description VALUES('job','state','done, failed, quarantined or cancelled');
INSERT INTO schema_description VALUES('job','success_rate','Eq. 8.1: successes / cycles_run');
INSERT INTO schema_description VALUES('job','successes','Mutations better than the last accepted state');
INSERT INTO schema_description VALUES('job','sweep','The sweep''s key');
INSERT INTO schema_description VALUES('job','trace','JSON array of the accepted changes, [cycle, stability, distance, fuel, total] each');
INSERT INTO schema_description VALUES('job','worker','Key of the worker that computed it; NULL if none did');
INSERT INTO schema_description VALUES('operators','','Every combination of mutation, steps and acceptance: all bar charts at once.');
INSERT INTO schema_description VALUES('operators','acceptance','Whether only changes for the better (or equal) are kept, or occasionally worse ones too');
INSERT INTO schema_description VALUES('operators','criterion','What must not get worse for a change to be kept: each component''s error, or their sum');
INSERT INTO schema_description VALUES('operators','cycles','How many mutations are tried');
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
INSERT INTO schema_description VALUES('operators','mutation','Which child neurons each mutation changes: all, one at random, or those of a random pair of legs');
INSERT INTO schema_description VALUES('operators','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had');
INSERT INTO schema_description VALUES('operators','other_parameters','JSON object of all other parameters; jobs that differ in one are not averaged');
INSERT INTO schema_description VALUES('operators','posture','Whether each evaluation starts from standing or from where the robot stands after the one before');
INSERT INTO schema_description VALUES('operators','steps','How the change of each mutated time is drawn');
INSERT INTO schema_description VALUES('operators','success_rate','Average of success_rate');
INSERT INTO schema_description VALUES('operators','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('progress','','One row per sweep: how far it is.');
INSERT INTO schema_description VALUES('progress','cancelled','Jobs that were cancelled');
INSERT INTO schema_description VALUES('progress','divergences','Results that contradicted the stored ones');
INSERT INTO schema_description VALUES('progress','done','Jobs that have an outcome');
INSERT INTO schema_description VALUES('progress','ended','When it was finished or cancelled, UTC; NULL before');
INSERT INTO schema_description VALUES('progress','failed','Jobs that ended without one');
INSERT INTO schema_description VALUES('progress','jobs','Number of its jobs');
INSERT INTO schema_description VALUES('progress','jobs_per_second','Ended jobs per second from submission to the latest result, pauses included; NULL before the first');
INSERT INTO schema_description VALUES('progress','pending','Jobs that have not ended, leased ones included');
INSERT INTO schema_description VALUES('progress','quarantined','Jobs given up after a number of attempts');
INSERT INTO schema_description VALUES('progress','seconds_left','Time that the pending jobs need at that rate; NULL if it isn''t known');
INSERT INTO schema_description VALUES('progress','state','running, finished, cancelling or cancelled');
INSERT INTO schema_description VALUES('progress','submitted','When it was submitted, UTC');
INSERT INTO schema_description VALUES('progress','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('result','','One row per job that has ended, with one column per parameter.');
INSERT INTO schema_description VALUES('result','acceptance','Whether only changes for the better (or equal) are kept, or occasionally worse ones too');
INSERT INTO schema_description VALUES('result','attempt','Which attempt this is the end of, from 1');
INSERT INTO schema_description VALUES('result','cooling','The factor on the temperature after every cycle; 1 keeps it constant; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','criterion','What must not get worse for a change to be kept: each component''s error, or their sum');
INSERT INTO schema_description VALUES('result','cycles','How many mutations are tried');
INSERT INTO schema_description VALUES('result','digest','SHA-256 over the job''s identity and outcome, 64 hex digits; NULL unless done');
INSERT INTO schema_description VALUES('result','equilibrium_disturbance','How far each time of a disturbed neuron is moved at the start, as a share of the range of 10 steps (%)');
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
INSERT INTO schema_description VALUES('result','gait','The gait that the network is preset with and that sets the expected fitness');
INSERT INTO schema_description VALUES('result','highest_distance','Distance (eq. 7.7) of the accepted state with the highest total');
INSERT INTO schema_description VALUES('result','highest_fuel','Fuel (eq. 7.9) of the accepted state with the highest total');
INSERT INTO schema_description VALUES('result','highest_stability','Stability (eq. 7.5) of the accepted state with the highest total');
INSERT INTO schema_description VALUES('result','highest_total','Weighted total (eq. 7.4) of the accepted state with the highest total');
INSERT INTO schema_description VALUES('result','initial_distance','Distance (eq. 7.7) after the disturbance, before the first mutation');
INSERT INTO schema_description VALUES('result','initial_fuel','Fuel (eq. 7.9) after the disturbance, before the first mutation');
INSERT INTO schema_description VALUES('result','initial_stability','Stability (eq. 7.5) after the disturbance, before the first mutation');
INSERT INTO schema_description VALUES('result','initial_total','Weighted total (eq. 7.4) after the disturbance, before the first mutation');
INSERT INTO schema_description VALUES('result','job','Number of the job within its sweep, from 0');
INSERT INTO schema_description VALUES('result','maximum_standard_deviation','The largest standard deviation that the 1/5 rule goes up to (steps); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','minimum_standard_deviation','The smallest standard deviation that the 1/5 rule goes down to (steps); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','mutation','Which child neurons each mutation changes: all, one at random, or those of a random pair of legs');
INSERT INTO schema_description VALUES('result','mutation_size','The largest uniform step, twice the standard deviation of a normal one, as a share of 10 time steps (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','network','The neural network that generates the gait');
INSERT INTO schema_description VALUES('result','objective','What is sought: the fitness of the undisturbed gait, or as much as can be had');
INSERT INTO schema_description VALUES('result','posture','Whether each evaluation starts from standing or from where the robot stands after the one before');
INSERT INTO schema_description VALUES('result','repeatability','bitwise: any machine computes the same bits again; NULL unless done');
INSERT INTO schema_description VALUES('result','replicate','Number of its replicate, from 0');
INSERT INTO schema_description VALUES('result','required_distance','The weight of distance in the fitness (%)');
INSERT INTO schema_description VALUES('result','required_fuel','The weight of the fuel that remains in the fitness (%)');
INSERT INTO schema_description VALUES('result','required_stability','The weight of stability in the fitness (%)');
INSERT INTO schema_description VALUES('result','robot','The robot that is controlled');
INSERT INTO schema_description VALUES('result','seconds','Time that its computation took; not deterministic');
INSERT INTO schema_description VALUES('result','seed','Seed of its random streams; decimal text from 2^63 on');
INSERT INTO schema_description VALUES('result','standard_deviation_factor','What the 1/5 rule multiplies the standard deviation by to shrink it, and divides it by to widen it; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','state','done, failed, quarantined or cancelled');
INSERT INTO schema_description VALUES('result','step_variance','Whether the variance of normal steps is constant or is multiplied by the square root of the error; NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','steps','How the change of each mutated time is drawn');
INSERT INTO schema_description VALUES('result','success_rate','Eq. 8.1: successes / cycles');
INSERT INTO schema_description VALUES('result','success_window','How many mutations the 1/5 rule counts successes over before it adapts (mutations); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('result','system_disturbance','The share of the eight child neurons that is disturbed at the start (%); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','temperature','The temperature that scales how much worse a change may be and still be kept (fitness); NULL where it doesn''t apply');
INSERT INTO schema_description VALUES('result','time_steps','The length of one evaluation of the robot (steps)');
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
INSERT INTO schema_description VALUES('sweep','cancelled','Number of its jobs in state cancelled');
INSERT INTO schema_description VALUES('sweep','checksum','SHA-256 over id, name, specification, source, seed, replicates, jobs and science_version');
INSERT INTO schema_description VALUES('sweep','created','When it was submitted, Unix time in milliseconds');
INSERT INTO schema_description VALUES('sweep','divergences','Number of its rows in divergence');
INSERT INTO schema_description VALUES('sweep','done','Number of its jobs in state done');
INSERT INTO schema_description VALUES('sweep','ended','When it was finished or cancelled, Unix time in milliseconds; NULL before');
INSERT INTO schema_description VALUES('sweep','failed','Number of its jobs in state failed');
INSERT INTO schema_description VALUES('sweep','id','Id, 32 hex digits, from the canonical specification');
INSERT INTO schema_description VALUES('sweep','jobs','Number of jobs: cells of all grids times replicates');
INSERT INTO schema_description VALUES('sweep','last_result','When its latest job ended, Unix time in milliseconds; NULL before the first');
INSERT INTO schema_description VALUES('sweep','name','Name given in the sweep file');
INSERT INTO schema_description VALUES('sweep','quarantined','Number of its jobs in state quarantined');
INSERT INTO schema_description VALUES('sweep','replicates','Number of replicates of each cell of the grid');
INSERT INTO schema_description VALUES('sweep','science_version','Version of the models and operators that it runs under');
INSERT INTO schema_description VALUES('sweep','seed','Seed of all its jobs; 64 bits, those from 2^63 on appear as negative');
INSERT INTO schema_description VALUES('sweep','source','The sweep file as its author wrote it; may be empty');
INSERT INTO schema_description VALUES('sweep','specification','Protobuf message lamprey.idl.SweepSpecification');
INSERT INTO schema_description VALUES('sweep','state','running, finished, cancelling or cancelled');
INSERT INTO schema_description VALUES('sweep','sweep','Key, in order of submission');
INSERT INTO schema_description VALUES('trace','','One row per accepted change of each job. Ask for one sweep and few jobs: a large sweep has millions of rows.');
INSERT INTO schema_description VALUES('trace','cycle','Cycle whose mutation was accepted, from 0');
INSERT INTO schema_description VALUES('trace','distance','Distance (eq. 7.7) after it');
INSERT INTO schema_description VALUES('trace','fuel','Fuel (eq. 7.9) after it');
INSERT INTO schema_description VALUES('trace','job','Number of the job within its sweep, from 0');
INSERT INTO schema_description VALUES('trace','stability','Stability (eq. 7.5) after it');
INSERT INTO schema_description VALUES('trace','sweep','Name of the sweep');
INSERT INTO schema_description VALUES('trace','total','Weighted total (eq. 7.4) after it');
INSERT INTO schema_description VALUES('worker','','One row per run of a worker process that has joined.');
INSERT INTO schema_description VALUES('worker','build','Version and compiler that it was built with');
INSERT INTO schema_description VALUES('worker','dds','DDS implementation that it used');
INSERT INTO schema_description VALUES('worker','first_seen','When it first appeared, Unix time in milliseconds');
INSERT INTO schema_description VALUES('worker','host','Name of its host');
INSERT INTO schema_description VALUES('worker','last_seen','When this row was last brought up to date, Unix time in milliseconds');
INSERT INTO schema_description VALUES('worker','process','Its process id there');
INSERT INTO schema_description VALUES('worker','threads','Number of its computing threads');
INSERT INTO schema_description VALUES('worker','worker','Key: the worker''s incarnation, 64 bits; printf(''%016x'', worker) in logs');
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
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep WHERE j.state = 'done'
GROUP BY 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 17;
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
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep WHERE j.state = 'done' AND CAST(json_extract(j.parameters, '$.steps') AS TEXT) = 'one_fifth_rule'
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
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep WHERE j.state = 'done' AND CAST(json_extract(j.parameters, '$.mutation') AS TEXT) = 'all' AND CAST(json_extract(j.parameters, '$.steps') AS TEXT) IN ('normal', 'uniform')
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
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep WHERE j.state = 'done' AND CAST(json_extract(j.parameters, '$.mutation') AS TEXT) = 'one' AND CAST(json_extract(j.parameters, '$.steps') AS TEXT) IN ('normal', 'uniform')
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
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep WHERE j.state = 'done' AND CAST(json_extract(j.parameters, '$.mutation') AS TEXT) = 'some' AND CAST(json_extract(j.parameters, '$.steps') AS TEXT) IN ('normal', 'uniform')
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
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep WHERE j.state = 'done' AND CAST(json_extract(j.parameters, '$.steps') AS TEXT) = 'normal' AND CAST(json_extract(j.parameters, '$.acceptance') AS TEXT) = 'simple'
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
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep WHERE j.state = 'done' AND CAST(json_extract(j.parameters, '$.steps') AS TEXT) = 'normal' AND CAST(json_extract(j.parameters, '$.acceptance') AS TEXT) = 'annealing'
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
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep WHERE j.state = 'done' AND CAST(json_extract(j.parameters, '$.steps') AS TEXT) = 'uniform' AND CAST(json_extract(j.parameters, '$.acceptance') AS TEXT) = 'simple'
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
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep WHERE j.state = 'done' AND CAST(json_extract(j.parameters, '$.steps') AS TEXT) = 'uniform' AND CAST(json_extract(j.parameters, '$.acceptance') AS TEXT) = 'annealing'
GROUP BY 1, 2, 3, 4, 5, 6, 7, 8, 15;
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
FROM job AS j JOIN sweep AS s ON s.sweep = j.sweep WHERE j.state = 'done'
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
  CAST((1000.0 * (done + failed + quarantined + cancelled) / nullif(last_result - created, 0)) AS REAL) AS "jobs_per_second",
  CAST((jobs - (done + failed + quarantined + cancelled)) / nullif((1000.0 * (done + failed + quarantined + cancelled) / nullif(last_result - created, 0)), 0) AS REAL) AS "seconds_left",
  strftime('%Y-%m-%dT%H:%M:%SZ', created / 1000, 'unixepoch') AS "submitted",
  strftime('%Y-%m-%dT%H:%M:%SZ', ended / 1000, 'unixepoch') AS "ended"
FROM sweep;
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
  CAST(json_extract(j.parameters, '$.gait') AS TEXT) AS "gait",
  CAST(json_extract(j.parameters, '$.mutation') AS TEXT) AS "mutation",
  CAST(json_extract(j.parameters, '$.steps') AS TEXT) AS "steps",
  CAST(json_extract(j.parameters, '$.acceptance') AS TEXT) AS "acceptance",
  CAST(json_extract(j.parameters, '$.equilibrium_disturbance') AS INTEGER) AS "equilibrium_disturbance",
  CAST(json_extract(j.parameters, '$.mutation_size') AS INTEGER) AS "mutation_size",
  CAST(json_extract(j.parameters, '$.system_disturbance') AS INTEGER) AS "system_disturbance",
  CAST(json_extract(j.parameters, '$.required_stability') AS INTEGER) AS "required_stability",
  CAST(json_extract(j.parameters, '$.required_distance') AS INTEGER) AS "required_distance",
  CAST(json_extract(j.parameters, '$.required_fuel') AS INTEGER) AS "required_fuel",
  CAST(json_extract(j.parameters, '$.cycles') AS INTEGER) AS "cycles",
  CAST(json_extract(j.parameters, '$.time_steps') AS INTEGER) AS "time_steps",
  CAST(json_extract(j.parameters, '$.objective') AS TEXT) AS "objective",
  CAST(json_extract(j.parameters, '$.criterion') AS TEXT) AS "criterion",
  CAST(json_extract(j.parameters, '$.posture') AS TEXT) AS "posture",
  CAST(json_extract(j.parameters, '$.temperature') AS REAL) AS "temperature",
  CAST(json_extract(j.parameters, '$.cooling') AS REAL) AS "cooling",
  CAST(json_extract(j.parameters, '$.step_variance') AS TEXT) AS "step_variance",
  CAST(json_extract(j.parameters, '$.first_standard_deviation') AS REAL) AS "first_standard_deviation",
  CAST(json_extract(j.parameters, '$.success_window') AS INTEGER) AS "success_window",
  CAST(json_extract(j.parameters, '$.standard_deviation_factor') AS REAL) AS "standard_deviation_factor",
  CAST(json_extract(j.parameters, '$.minimum_standard_deviation') AS REAL) AS "minimum_standard_deviation",
  CAST(json_extract(j.parameters, '$.maximum_standard_deviation') AS REAL) AS "maximum_standard_deviation",
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
  CAST(CASE j.state WHEN 'done' THEN 'bitwise' END AS TEXT) AS "repeatability"
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
COMMIT;

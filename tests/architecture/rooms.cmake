# The rooms of the house, the lowest first, and what each may include besides itself. The build links
# the library of a room to the libraries of these (gurney_room in CMakeLists.txt);
# tests/architecture/include_direction.cmake fails for any other #include. `./dev rooms` prints who
# includes whom how often.
set(GURNEY_ROOMS
  "engine/base:"
  "engine/config: engine/base"
  "engine/scene: engine/base"
  "engine/contact: engine/base engine/scene"
  "engine/caster: engine/base engine/scene engine/contact"
  "engine/response: engine/base engine/scene"
  "engine/solver: engine/base engine/scene engine/contact engine/caster engine/response"
  "engine/bullet: engine/base engine/scene engine/contact engine/solver"
  "engine/record: engine/base engine/scene engine/response engine/solver"
  "engine/baselines: engine/base engine/scene engine/response engine/solver engine/bullet
    engine/record"
  "engine/run: engine/base engine/scene engine/response engine/solver engine/bullet engine/record
    engine/baselines"
  "groundmotions/record: engine/base"
  "groundmotions/formats: engine/base engine/config groundmotions/record"
  "groundmotions/measures: engine/base engine/config groundmotions/record"
  "groundmotions/models: engine/base"
  "groundmotions/processing: engine/base engine/config groundmotions/record groundmotions/measures"
  "groundmotions/assembly: engine/base groundmotions/record groundmotions/formats
    groundmotions/processing"
  "groundmotions/synthetic: engine/base engine/config groundmotions/record groundmotions/formats
    groundmotions/measures"
  "groundmotions/scaling: engine/base engine/config groundmotions/record groundmotions/formats
    groundmotions/synthetic"
  "groundmotions/suites: engine/base engine/config groundmotions/record groundmotions/formats
    groundmotions/assembly"
  "groundmotions/buildings: engine/base engine/config groundmotions/record groundmotions/measures"
  "groundmotions/tools: groundmotions/synthetic"
  "equipment/catalogue: engine/base engine/config engine/scene"
  "studies/build_info:"
  "studies/statistics: engine/base"
  "studies/verification/scenes: engine/base engine/scene engine/response"
  "studies/verification: engine/base engine/config engine/scene engine/contact engine/response
    engine/solver engine/run studies/verification/scenes"
  "studies/study/job: engine/base engine/config engine/scene engine/run groundmotions/record
    groundmotions/measures groundmotions/processing groundmotions/assembly groundmotions/synthetic
    groundmotions/scaling groundmotions/suites groundmotions/buildings equipment/catalogue"
  "studies/study/units: engine/base engine/config"
  "studies/study/results: engine/base engine/scene engine/response studies/build_info"
  "studies/study/prepare: engine/base engine/scene groundmotions/record groundmotions/measures
    groundmotions/processing groundmotions/assembly groundmotions/buildings equipment/catalogue
    studies/study/job studies/study/results"
  "studies/study/limit_states: engine/base engine/config engine/scene engine/response
    studies/study/results"
  "studies/study/plan: engine/base engine/config groundmotions/record groundmotions/assembly
    groundmotions/suites equipment/catalogue studies/statistics studies/study/job studies/study/prepare
    studies/study/limit_states"
  "studies/study/run: engine/base engine/config engine/response engine/run studies/build_info
    studies/statistics studies/study/results studies/study/prepare studies/study/limit_states
    studies/study/plan"
  "studies/study/analysis: engine/base engine/config engine/response
    groundmotions/measures studies/statistics studies/study/job studies/study/units
    studies/study/results studies/study/limit_states studies/study/plan"
  "studies/study/convergence: engine/base engine/run studies/statistics studies/study/results
    studies/study/prepare studies/study/limit_states studies/study/run"
  "studies/study/exports: engine/base engine/config engine/scene groundmotions/measures
    equipment/catalogue studies/statistics studies/study/units studies/study/results
    studies/study/limit_states studies/study/analysis"
  "studies/calibration/trials: engine/base engine/config engine/scene"
  "studies/calibration/fit: engine/base engine/config engine/scene engine/run equipment/catalogue
    studies/statistics studies/calibration/trials"
  "studies/calibration/pulling: engine/base engine/scene equipment/catalogue studies/study/results
    studies/study/plan studies/study/exports studies/calibration/trials"
  "studies/findings:"
  "studies/render: studies/findings"
  "studies/report: engine/base engine/scene engine/response groundmotions/record
    groundmotions/measures groundmotions/assembly groundmotions/buildings equipment/catalogue
    studies/build_info studies/verification studies/study/units studies/study/results studies/study/analysis
    studies/study/convergence studies/calibration/trials studies/calibration/fit studies/calibration/pulling
    studies/findings studies/render"
  "studies/figures: engine/base engine/scene engine/response groundmotions/record
    groundmotions/measures groundmotions/scaling equipment/catalogue studies/statistics
    studies/verification studies/study/units studies/study/results studies/study/analysis
    studies/study/convergence studies/calibration/trials studies/calibration/fit studies/report"
  "studies/explanation: engine/base engine/scene engine/response engine/run
    equipment/catalogue studies/statistics studies/study/units studies/study/results studies/render
    studies/report studies/figures"
  "studies/picture: engine/base"
  "studies/page: engine/base engine/config engine/scene equipment/catalogue studies/build_info
    studies/study/job studies/study/units studies/study/results studies/study/plan
    studies/study/analysis studies/findings studies/report studies/figures studies/explanation"
  "studies/playback: engine/base engine/response studies/study/results"
  "studies/doctor: engine/base equipment/catalogue studies/build_info studies/study/results
    studies/study/run studies/picture"
  "studies/templates: engine/base"
  "studies/bindings: engine/base engine/config engine/response engine/run groundmotions/record
    equipment/catalogue studies/build_info studies/study/job studies/study/results
    studies/study/prepare"
  "studies/cli: engine/base engine/config engine/response engine/run groundmotions/record
    groundmotions/formats groundmotions/measures groundmotions/models groundmotions/processing
    groundmotions/synthetic groundmotions/scaling groundmotions/suites groundmotions/buildings
    equipment/catalogue studies/build_info studies/verification studies/study/job studies/study/units
    studies/study/results
    studies/study/prepare studies/study/limit_states studies/study/plan studies/study/run
    studies/study/analysis studies/study/exports studies/calibration/fit
    studies/calibration/pulling studies/render studies/report studies/figures
    studies/explanation studies/picture
    studies/page studies/playback studies/doctor studies/templates")

# Libraries that only these rooms, or files that begin so, may include, by how their headers begin.
set(GURNEY_LIBRARIES
  "bt[A-Z]|Bullet|LinearMath/: engine/bullet engine/baselines"
  "toml: engine/config"
  "openssl/: engine/base"
  "boost/: engine/base groundmotions/synthetic studies/statistics"
  "hdf5|H5: studies/study/results/hdf5_"
  "nlohmann/: engine/config studies/study/exports studies/render studies/report studies/explanation
    studies/page studies/playback studies/cli"
  "cairo|librsvg/: studies/picture/rendering"
  "CLI/: studies/cli"
  "pybind11/: studies/bindings")

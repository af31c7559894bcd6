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
  "groundmotions/hazard: engine/base engine/config groundmotions/formats groundmotions/measures"
  "groundmotions/selection: engine/base engine/config groundmotions/formats groundmotions/models
    groundmotions/hazard groundmotions/scaling groundmotions/suites"
  "groundmotions/buildings: engine/base engine/config groundmotions/record groundmotions/formats
    groundmotions/measures"
  "groundmotions/tools: groundmotions/synthetic"
  "equipment/catalogue: engine/base engine/config engine/scene engine/contact engine/bullet engine/run"
  "studies/build_info:"
  "studies/statistics: engine/base"
  "studies/verification/scenes: engine/base engine/scene engine/response"
  "studies/verification: engine/base engine/config engine/scene engine/contact engine/response
    engine/solver engine/run studies/verification/scenes"
  "studies/job: engine/base engine/config engine/scene engine/contact engine/run groundmotions/record
    groundmotions/measures groundmotions/processing groundmotions/assembly groundmotions/synthetic
    groundmotions/scaling groundmotions/suites groundmotions/buildings equipment/catalogue"
  "studies/units: engine/base engine/config"
  "studies/results: engine/base engine/scene engine/response engine/run studies/build_info"
  "studies/prepare: engine/base engine/scene groundmotions/record groundmotions/measures
    groundmotions/processing groundmotions/assembly groundmotions/buildings equipment/catalogue
    studies/job studies/results"
  "studies/limit_states: engine/base engine/config engine/scene engine/response
    studies/results"
  "studies/plan: engine/base engine/config groundmotions/record groundmotions/assembly
    groundmotions/hazard groundmotions/suites equipment/catalogue studies/statistics studies/job studies/prepare
    studies/limit_states"
  "studies/run: engine/base engine/config engine/response engine/run studies/build_info
    studies/statistics studies/results studies/prepare studies/limit_states
    studies/plan"
  "studies/analysis: engine/base engine/config engine/response
    groundmotions/measures studies/statistics studies/job studies/units
    studies/results studies/limit_states studies/plan"
  "studies/loss: engine/base engine/config equipment/catalogue studies/statistics
    studies/limit_states studies/analysis"
  "studies/hospital: engine/base engine/config groundmotions/formats equipment/catalogue
    studies/statistics studies/plan studies/analysis studies/loss"
  "studies/convergence: engine/base engine/run studies/statistics studies/results
    studies/prepare studies/limit_states studies/run"
  "studies/exports: engine/base engine/config engine/scene groundmotions/measures
    equipment/catalogue studies/statistics studies/units studies/results
    studies/limit_states studies/analysis studies/loss"
  "studies/calibration/trials: engine/base engine/config engine/scene"
  "studies/calibration/fit: engine/base engine/config engine/scene engine/run equipment/catalogue
    studies/statistics studies/calibration/trials"
  "studies/calibration/pulling: engine/base engine/scene equipment/catalogue studies/results
    studies/plan studies/exports studies/calibration/trials"
  "studies/findings:"
  "studies/render: engine/base studies/findings"
  "studies/explanation: engine/base engine/scene engine/response engine/run equipment/catalogue
    studies/statistics studies/units studies/results studies/findings"
  "studies/report: engine/base engine/config engine/scene engine/response groundmotions/record
    groundmotions/measures groundmotions/assembly groundmotions/buildings equipment/catalogue
    studies/build_info studies/verification studies/units studies/results studies/analysis
    studies/loss studies/hospital studies/convergence studies/calibration/trials
    studies/calibration/fit studies/calibration/pulling
    studies/findings studies/render studies/explanation"
  "studies/playback: engine/base engine/response studies/results studies/render studies/explanation"
  "studies/figures: engine/base engine/scene engine/response groundmotions/record
    groundmotions/measures groundmotions/scaling groundmotions/selection equipment/catalogue
    studies/statistics studies/verification studies/units studies/results studies/analysis
    studies/loss studies/hospital studies/convergence studies/calibration/trials studies/calibration/fit
    studies/explanation studies/report studies/playback"
  "studies/picture: engine/base"
  "studies/page: engine/base engine/config engine/scene engine/run equipment/catalogue studies/build_info
    studies/job studies/units studies/results studies/plan
    studies/analysis studies/findings studies/loss studies/render studies/report studies/figures
    studies/explanation"
  "studies/doctor: engine/base equipment/catalogue studies/build_info studies/results
    studies/run studies/picture"
  "studies/templates: engine/base"
  "studies/bindings: engine/base engine/config engine/response engine/run groundmotions/record
    equipment/catalogue studies/build_info studies/job studies/results
    studies/prepare studies/limit_states studies/plan studies/analysis"
  "studies/workbench: engine/base engine/baselines engine/config engine/scene engine/response engine/run
    groundmotions/suites groundmotions/synthetic equipment/catalogue studies/bindings studies/build_info studies/job
    studies/results studies/prepare studies/limit_states studies/statistics studies/findings studies/render
    studies/explanation studies/report studies/playback"
  "studies/cli: engine/base engine/config engine/response engine/run groundmotions/record
    groundmotions/formats groundmotions/measures groundmotions/models groundmotions/processing
    groundmotions/synthetic groundmotions/scaling groundmotions/suites groundmotions/selection
    groundmotions/buildings equipment/catalogue studies/build_info studies/verification studies/job studies/units
    studies/results
    studies/prepare studies/limit_states studies/plan studies/run
    studies/analysis studies/loss studies/hospital studies/exports studies/calibration/fit
    studies/calibration/pulling studies/findings studies/render studies/report studies/figures
    studies/explanation studies/picture
    studies/page studies/playback studies/doctor studies/templates")

# Libraries that only these rooms, or files that begin so, may include, by how their headers begin.
set(GURNEY_LIBRARIES
  "bt[A-Z]|Bullet|LinearMath/: engine/bullet engine/baselines"
  "toml: engine/config"
  "openssl/: engine/base"
  "boost/: engine/base groundmotions/synthetic studies/statistics"
  "hdf5|H5: studies/results/hdf5_"
  "nlohmann/: engine/config groundmotions/formats/event_file studies/exports studies/render
    studies/page studies/playback studies/workbench studies/cli"
  "cairo|librsvg/: studies/picture/picture"
  "CLI/: studies/cli"
  "pybind11/: studies/bindings")

#include <algorithm>
#include <cmath>

#include "studies/verification/family.h"
#include "studies/verification/scenes/blocks.h"
#include "studies/verification/scenes/small_scenes.h"

// An item that moves at V and is stopped at a point that it can turn about falls over it when its centre of
// mass, h above that point, R from it, is thrown up from h to R: angular momentum gives w = M h V /
// I_O about the point.
namespace gurney::verification {
namespace {

double tripping_speed(const MassProperties& body, const Vector3& pivot) {
  const Vector3 arm = body.center_of_mass - pivot;
  const double radius = std::hypot(arm.x(), arm.z());
  const double inertia = body.inertia(1, 1) + body.mass * radius * radius;
  return std::sqrt(2 * kG * (radius - arm.z()) * inertia / body.mass) / arm.z();
}

/// The centre, b behind the pivot, goes on a circle about it. With w' = -M g b / I_O and, of the
/// least w that is enough, w^2 = 2 M g (R - h) / I_O, the pivot's force along the motion is
///
///     M (w^2 b + w' h) = (M b) (M g / I_O) (2 R - 3 h)
///
/// at the stop, and less from then on. A kerb cannot pull: what is lower rolls back from it.
bool leans_on_kerb(const MassProperties& body, const Vector3& pivot) {
  const Vector3 arm = body.center_of_mass - pivot;
  return 3 * arm.z() > 2 * std::hypot(arm.x(), arm.z());
}

constexpr double kWay = 0.02;  // to the kerb [m]

void add_kerb(Scene& scene, double face, double height) {
  scene.room.push_back({"kerb",
                        scene.items[0].model.material.empty() ? "" : "stone",
                        {face + 0.1, 0, 0.5 * height - 0.05},
                        Quaternion::Identity(),
                        RoomBox{{0.2, 2, height + 0.1}}});
}

bool has_fallen(const Response& response) {
  const Quaternion& end = response.items[0].history.back().orientation;
  return response.outcome == Outcome::kOverturned && (end * Vector3::UnitZ()).x() > 0;
}

/// Whether it falls over the kerb: what lands again may fall over its back. An item that stays up is judged
/// until it is highest: it lands on treads too stiff for these steps, which is not asked.
bool falls(Scene scene, double speed, double step, Runner& runner, double& closure) {
  constexpr double kDuration = 3, kHistoryStep = 0.01;
  scene.items[0].initial.velocity = {speed, 0, 0};
  SimulationSettings settings = blocks::run_for(kDuration, step, kHistoryStep);
  settings.follow_overturning = false;
  Response response = runner.unjudged(scene, {}, settings);
  const bool fallen = has_fallen(response);
  if (!fallen) {
    const auto& history = response.items[0].history;
    settings.duration = std::ranges::max_element(history, {}, &Sample::tilt)->time;
    response = runner.unjudged(scene, {}, settings);
  }
  runner.judge(response);
  closure = std::max(closure, response.quality.energy_closure);
  return fallen;
}

void trip(const Scene& scene, double speed, double share, const char* terms, double step,
          Runner& runner) {
  const double bracket = share / 4;
  double closure = 0;
  const double found = locate((1 - 2 * share) * speed, (1 + 2 * share) * speed, bracket * speed,
                              [&](double v) { return falls(scene, v, step, runner, closure); });
  runner.check("speed from which it overturns", "m/s", found,
               near_to(speed, (share + bracket / 2) * speed, terms));
  runner.check(
      "energy balance error", "", closure,
      near_to(0, 0.01, "1 %: 32 steps or more in the impact lose (pi/32)^2 of what it takes"));
}

// --- a cart whose front wheels meet a kerb higher than their axle

struct Cart {
  double mass, height;  // of the chassis and its centre [kg], [m]
  double ahead = 0;     // of the centre [m]
  double gyration = 0.3, half_wheelbase = 0.4, half_track = 0.2, friction = 0;  // [m], treads
};

struct CartAtKerb {
  Scene scene = scene_of({});
  double speed = 0, share = 0;
  bool leans = false;
};

CartAtKerb cart_at(const Cart& c) {
  constexpr double kStiffness = 1e8;
  Tread tread = small::bare_tread(kStiffness, kStiffness);
  tread.normal_damping = 4e5;  // no rebound: more than 2 sqrt(k M)
  tread.static_friction = tread.kinetic_friction = c.friction;
  CartAtKerb result;
  EquipmentModel& cart = result.scene.items[0].model;
  const double x = c.half_wheelbase, y = c.half_track;
  cart = small::item_on({{x, y}, {x, -y}, {-x, y}, {-x, -y}}, {0, 0, 0, 0}, tread);
  for (Caster& caster : cart.casters) {
    caster.swivels = false;
    caster.trail = 0;
    caster.fork_center_of_mass.x() = 0;
  }
  cart.chassis_mass = c.mass;
  cart.chassis_center_of_mass = {c.ahead, 0, c.height};
  cart.chassis_inertia = c.mass * c.gyration * c.gyration * Matrix3::Identity();
  cart.shape = {{{0, 0, 0.6}, {0.1, 0.1, 0.1}}};
  // The kerb holds the front wheels in the corner with the floor; the cart turns about their axle.
  // Wheels that turn freely count with their mass only.
  const double radius = cart.casters[0].wheel_radius;
  add_kerb(result.scene, x + radius + kWay, 0.08);
  MassProperties moving = whole_item(cart);
  for (const Caster& caster : cart.casters) moving.inertia(1, 1) -= caster.wheel_axial_inertia;
  const Vector3 axle(x, 0, radius);
  result.speed = tripping_speed(moving, axle);
  result.leans = leans_on_kerb(moving, axle);
  const double h = moving.center_of_mass.z() - radius;
  const double deflection = result.speed * std::sqrt(moving.mass / (2 * kStiffness)) / h;
  const double spin =
      c.friction > 0 ? 2 * cart.casters[0].wheel_axial_inertia / (radius * radius) / moving.mass
                     : 0;
  result.share = 2 * deflection + spin;
  return result;
}

void stop_cart(const Cart& c, Runner& runner) {
  const CartAtKerb result = cart_at(c);
  trip(result.scene, result.speed, result.share,
       "of it: the axle deflects by V sqrt(M / 2 k) forward and, as it swings, down, twice that "
       "over h; friction at the kerb lifts wheels while it stops their spin, I / R^2 of two over "
       "M; an eighth of these for the last bracket",
       0.0005, runner);
}

/// The centre stays well behind the axle.
bool can_trip(const Cart& c) { return c.ahead < 0.6 * c.half_wheelbase && cart_at(c).leans; }

// --- a block that slides without friction

struct Slider {
  double mass, width, height;        // [kg], [m], [m]
  double aside = 0, center = 0.5;    // of the centre [m], its height over `height`
  double inertia = 1, kerb = 0.001;  // over that of a box, [m]
};

struct SliderAtKerb {
  Scene scene = scene_of({});
  double speed = 0, share = 0;
  bool leans = false;
};

SliderAtKerb slider_at(const Slider& c) {
  constexpr double kStiffness = 1e9;
  const ContactConstants rigid{.stiffness = kStiffness, .restitution = 0.01, .friction = 0};
  SliderAtKerb result;
  result.scene = blocks::block(c.mass, {c.width, 0.5, c.height}, rigid);
  result.scene.pairs.push_back({"steel", "stone", rigid});
  EquipmentModel& block = result.scene.items[0].model;
  block.chassis_center_of_mass = {c.aside, 0, c.center * c.height};
  block.chassis_inertia *= c.inertia;
  add_kerb(result.scene, 0.5 * c.width + kWay, c.kerb);
  const MassProperties body = whole_item(block);
  const Vector3 edge(0.5 * c.width, 0, 0);
  result.speed = tripping_speed(body, edge);
  result.leans = leans_on_kerb(body, edge);
  const double raised = tripping_speed(body, edge + Vector3(0, 0, c.kerb));
  result.share = std::abs(raised / result.speed - 1) +
                 result.speed * std::sqrt(c.mass / kStiffness) / body.center_of_mass.z();
  return result;
}

void stop_slider(const Slider& c, Runner& runner) {
  const SliderAtKerb result = slider_at(c);
  trip(result.scene, result.speed, result.share,
       "of it: the kerb holds the edge between the floor and its top, V there and here; it gives "
       "way by V sqrt(M / k), over h; an eighth of these for the last bracket",
       0.001, runner);
}

bool can_tip(const Slider& c) {
  return std::abs(c.aside) < 0.25 * c.width && c.width < 0.7 * c.height && slider_at(c).leans;
}

}  // namespace

Family cart_at_kerb() {
  return make_family<Cart>(
      {"cart_at_kerb", "blocks",
       "The front wheels of a cart meet a kerb that is higher than their axle",
       "overturns from V = (1/h) sqrt(2 g (R - h) I_O / M) on, h and R from the front axle",
       "Mallet 1862, The Great Neapolitan Earthquake of 1857, part I; angular momentum"},
      fields(FIELD(Cart, mass, "kg", 30, 200), FIELD(Cart, height, "m", 0.4, 1.2),
             FIELD(Cart, ahead, "m", -0.1, 0.1), FIELD(Cart, gyration, "m", 0.2, 0.5),
             FIELD(Cart, half_wheelbase, "m", 0.25, 0.5), FIELD(Cart, half_track, "m", 0.15, 0.3),
             FIELD(Cart, friction, "", 0, 0.7)),
      cases(at("plain", 94.5, 0.618), at("high", 60, 0.9, 0, 0.25, 0.3),
            at("ahead", 150, 0.8, 0.1, 0.4, 0.35, 0.25),
            at("behind", 40, 1.1, -0.08, 0.5, 0.25, 0.25),
            at("rough", 94.5, 0.618, 0, 0.3, 0.4, 0.2, 0.6)),
      stop_cart, can_trip);
}

Family slider_at_kerb() {
  return make_family<Slider>(
      {"slider_at_kerb", "blocks", "A block slides without friction against a low kerb",
       "overturns from V = (1/h) sqrt(2 g (R - h) I_O / M) on, h and R from the front edge",
       "Mallet 1862, The Great Neapolitan Earthquake of 1857, part I; angular momentum"},
      fields(FIELD(Slider, mass, "kg", 30, 300), FIELD(Slider, width, "m", 0.25, 0.7),
             FIELD(Slider, height, "m", 0.8, 1.8), FIELD(Slider, aside, "m", -0.12, 0.12),
             FIELD(Slider, center, "of the height", 0.35, 0.65),
             FIELD(Slider, inertia, "of a box", 0.7, 1.4), FIELD(Slider, kerb, "m", 0.001, 0.01)),
      cases(at("plain", 100, 0.5, 1.0), at("high_kerb", 100, 0.5, 1.0, 0, 0.5, 1, 0.01),
            at("heavy", 250, 0.55, 1.5), at("ahead", 60, 0.43, 1.3, 0.06, 0.5 / 1.3, 0.8),
            at("behind", 120, 0.6, 1.25, -0.1, 0.64, 1.3)),
      stop_slider, can_tip);
}

}  // namespace gurney::verification

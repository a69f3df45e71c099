// The same falling wall in physics engines for games, beside wythe: time of a step and block, how deep blocks lie in
// each other, whether energy grows (benchmarks/README.md). Needs libbox2d-dev, chipmunk-dev and libbullet-dev.
//
// A dry tower, columns x courses in running bond, friction 0.6, no rebound. The ground is accelerated by 0.5 g for a
// second, which a rigid tower of these proportions cannot bear; in its own frame that is a constant force, so the sum
// of kinetic energy and potential (weight and that force) may only fall.
#include <box2d/box2d.h>
#include <btBulletDynamicsCommon.h>
#include <chipmunk/chipmunk.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <string>
#include <vector>

namespace {

constexpr double kLength = 0.25, kHeight = 0.125, kThickness = 0.25, kDensity = 2000;  // of a block
constexpr double kFriction = 0.6, kGravity = 9.81, kPush = 0.5 * kGravity, kPushed = 1.0;
constexpr double kDuration = 4.0, kLook = 0.02;  // [s]

struct Block {
  double x, y, width;
  [[nodiscard]] double mass() const { return kDensity * width * kHeight * kThickness; }
  [[nodiscard]] double inertia() const { return mass() * (width * width + kHeight * kHeight) / 12; }
};
struct Pose {
  double x, y, turn, vx, vy, spin;
};

std::vector<Block> tower(int columns, int courses) {
  std::vector<Block> blocks;
  for (int course = 0; course < courses; ++course) {
    const double y = (course + 0.5) * kHeight;
    const bool shifted = course % 2 != 0;
    if (shifted) blocks.push_back({0.25 * kLength, y, 0.5 * kLength});
    for (int c = 0; c < columns - (shifted ? 1 : 0); ++c)
      blocks.push_back({(c + (shifted ? 1.0 : 0.5)) * kLength, y, kLength});
    if (shifted) blocks.push_back({(columns - 0.25) * kLength, y, 0.5 * kLength});
  }
  return blocks;
}

// --- what is measured, from poses alone ---------------------------------------------------------------------------

using Corners = std::array<std::array<double, 2>, 4>;
Corners corners_of(const Block& b, const Pose& p) {
  const double c = std::cos(p.turn), s = std::sin(p.turn), w = 0.5 * b.width, h = 0.5 * kHeight;
  Corners out;
  const double at[4][2] = {{-w, -h}, {w, -h}, {w, h}, {-w, h}};
  for (int k = 0; k < 4; ++k)
    out[k] = {p.x + c * at[k][0] - s * at[k][1], p.y + s * at[k][0] + c * at[k][1]};
  return out;
}

// How far two boxes would have to move to part; 0 where they are apart.
double depth(const Corners& a, const Corners& b) {
  double least = 1e9;
  for (const Corners* of : {&a, &b})
    for (int k = 0; k < 2; ++k) {
      double nx = (*of)[k + 1][1] - (*of)[k][1], ny = (*of)[k][0] - (*of)[k + 1][0];
      const double length = std::hypot(nx, ny);
      nx /= length, ny /= length;
      double a0 = 1e9, a1 = -1e9, b0 = 1e9, b1 = -1e9;
      for (const auto& p : a)
        a0 = std::min(a0, nx * p[0] + ny * p[1]), a1 = std::max(a1, nx * p[0] + ny * p[1]);
      for (const auto& p : b)
        b0 = std::min(b0, nx * p[0] + ny * p[1]), b1 = std::max(b1, nx * p[0] + ny * p[1]);
      least = std::min({least, a1 - b0, b1 - a0});
    }
  return std::max(0.0, least);
}

struct Measured {
  double depth = 0;   // deepest of all times [m]
  double growth = 0;  // of the energy above its least so far [J]
  double fallen = 0;  // energy lost from the start to the end [J]
  double seconds = 0;
  long steps = 0;
};

class Meter {
 public:
  explicit Meter(const std::vector<Block>& blocks) : blocks_(blocks) {}
  void look(const std::vector<Pose>& poses, double push) {
    std::vector<Corners> corners;
    std::vector<std::size_t> order;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      corners.push_back(corners_of(blocks_[i], poses[i]));
      order.push_back(i);
      for (const auto& p : corners.back()) deepest_ = std::max(deepest_, -p[1]);
    }
    std::sort(order.begin(), order.end(), [&](auto a, auto b) { return poses[a].x < poses[b].x; });
    for (std::size_t i = 0; i < order.size(); ++i)
      for (std::size_t j = i + 1; j < order.size() && poses[order[j]].x - poses[order[i]].x < 0.3;
           ++j)
        if (std::fabs(poses[order[j]].y - poses[order[i]].y) < 0.3)
          deepest_ = std::max(deepest_, depth(corners[order[i]], corners[order[j]]));
    double energy = 0;
    for (std::size_t i = 0; i < poses.size(); ++i) {
      const Pose& p = poses[i];
      const double m = blocks_[i].mass();
      energy += 0.5 * m * (p.vx * p.vx + p.vy * p.vy) +
                0.5 * blocks_[i].inertia() * p.spin * p.spin + m * kGravity * p.y - m * push * p.x;
    }
    if (push != push_) least_ = energy;  // the field has changed
    push_ = push;
    growth_ = std::max(growth_, energy - least_);
    least_ = std::min(least_, energy);
  }
  [[nodiscard]] double deepest() const { return deepest_; }
  [[nodiscard]] double growth() const { return growth_; }

 private:
  const std::vector<Block>& blocks_;
  double deepest_ = 0, growth_ = 0, least_ = 1e99, push_ = kPush;
};

// --- engines ------------------------------------------------------------------------------------------------------

struct Engine {
  virtual ~Engine() = default;
  virtual void push(double acceleration) = 0;
  virtual void step(double dt) = 0;
  virtual std::vector<Pose> poses() const = 0;
};

class Box2D : public Engine {
 public:
  explicit Box2D(const std::vector<Block>& blocks)
      : world_({static_cast<float>(kPush), static_cast<float>(-kGravity)}) {
    b2BodyDef ground;
    b2PolygonShape floor;
    floor.SetAsBox(100, 1, {0, -1}, 0);
    b2Body* base = world_.CreateBody(&ground);
    base->CreateFixture(&floor, 0)->SetFriction(kFriction);
    for (const Block& b : blocks) {
      b2BodyDef def;
      def.type = b2_dynamicBody;
      def.position.Set(static_cast<float>(b.x), static_cast<float>(b.y));
      b2PolygonShape box;
      box.SetAsBox(static_cast<float>(b.width / 2), static_cast<float>(kHeight / 2));
      b2Body* body = world_.CreateBody(&def);
      body->CreateFixture(&box, static_cast<float>(kDensity * kThickness))->SetFriction(kFriction);
      bodies_.push_back(body);
    }
  }
  void push(double a) override {
    world_.SetGravity({static_cast<float>(a), static_cast<float>(-kGravity)});
  }
  void step(double dt) override { world_.Step(static_cast<float>(dt), 8, 3); }
  std::vector<Pose> poses() const override {
    std::vector<Pose> all;
    for (const b2Body* b : bodies_)
      all.push_back({b->GetPosition().x, b->GetPosition().y, b->GetAngle(),
                     b->GetLinearVelocity().x, b->GetLinearVelocity().y, b->GetAngularVelocity()});
    return all;
  }

 private:
  b2World world_;
  std::vector<b2Body*> bodies_;
};

class Chipmunk : public Engine {
 public:
  explicit Chipmunk(const std::vector<Block>& blocks) : space_(cpSpaceNew()) {
    push(kPush);
    cpSpaceSetIterations(space_, 10);
    cpShape* floor =
        cpSegmentShapeNew(cpSpaceGetStaticBody(space_), cpv(-100, -1), cpv(100, -1), 1);
    cpShapeSetFriction(floor, std::sqrt(kFriction));  // it multiplies both
    cpSpaceAddShape(space_, floor);
    shapes_.push_back(floor);
    for (const Block& b : blocks) {
      cpBody* body =
          cpSpaceAddBody(space_, cpBodyNew(b.mass(), cpMomentForBox(b.mass(), b.width, kHeight)));
      cpBodySetPosition(body, cpv(b.x, b.y));
      cpShape* box = cpSpaceAddShape(space_, cpBoxShapeNew(body, b.width, kHeight, 0));
      cpShapeSetFriction(box, std::sqrt(kFriction));
      shapes_.push_back(box);
      bodies_.push_back(body);
    }
  }
  ~Chipmunk() override {
    for (cpShape* s : shapes_) cpSpaceRemoveShape(space_, s), cpShapeFree(s);
    for (cpBody* b : bodies_) cpSpaceRemoveBody(space_, b), cpBodyFree(b);
    cpSpaceFree(space_);
  }
  void push(double a) override { cpSpaceSetGravity(space_, cpv(a, -kGravity)); }
  void step(double dt) override { cpSpaceStep(space_, dt); }
  std::vector<Pose> poses() const override {
    std::vector<Pose> all;
    for (const cpBody* b : bodies_) {
      const cpVect p = cpBodyGetPosition(b), v = cpBodyGetVelocity(b);
      all.push_back({p.x, p.y, cpBodyGetAngle(b), v.x, v.y, cpBodyGetAngularVelocity(b)});
    }
    return all;
  }

 private:
  cpSpace* space_;
  std::vector<cpBody*> bodies_;
  std::vector<cpShape*> shapes_;
};

class Bullet : public Engine {
 public:
  explicit Bullet(const std::vector<Block>& blocks)
      : dispatcher_(&configuration_),
        world_(&dispatcher_, &broadphase_, &solver_, &configuration_) {
    push(kPush);
    add(std::make_unique<btBoxShape>(btVector3(100, 1, 10)), 0, 0, -1);
    for (const Block& b : blocks) {
      btRigidBody* body =
          add(std::make_unique<btBoxShape>(btVector3(static_cast<btScalar>(b.width / 2),
                                                     static_cast<btScalar>(kHeight / 2),
                                                     static_cast<btScalar>(kThickness / 2))),
              b.mass(), b.x, b.y);
      body->getCollisionShape()->setMargin(0.001F);
      body->setLinearFactor(btVector3(1, 1, 0));
      body->setAngularFactor(btVector3(0, 0, 1));
      body->setActivationState(DISABLE_DEACTIVATION);
      bodies_.push_back(body);
    }
  }
  ~Bullet() override {
    for (auto& body : all_) world_.removeRigidBody(body.get());
  }
  void push(double a) override {
    world_.setGravity(btVector3(static_cast<btScalar>(a), static_cast<btScalar>(-kGravity), 0));
    for (btRigidBody* b : bodies_) b->setGravity(world_.getGravity());
  }
  void step(double dt) override { world_.stepSimulation(static_cast<btScalar>(dt), 0); }
  std::vector<Pose> poses() const override {
    std::vector<Pose> all;
    for (const btRigidBody* b : bodies_) {
      const btTransform& at = b->getWorldTransform();
      const btMatrix3x3& r = at.getBasis();
      all.push_back({at.getOrigin().x(), at.getOrigin().y(), std::atan2(r[1][0], r[0][0]),
                     b->getLinearVelocity().x(), b->getLinearVelocity().y(),
                     b->getAngularVelocity().z()});
    }
    return all;
  }

 private:
  btRigidBody* add(std::unique_ptr<btCollisionShape> shape, double mass, double x, double y) {
    btVector3 inertia(0, 0, 0);
    if (mass > 0) shape->calculateLocalInertia(static_cast<btScalar>(mass), inertia);
    btRigidBody::btRigidBodyConstructionInfo info(static_cast<btScalar>(mass), nullptr, shape.get(),
                                                  inertia);
    info.m_friction = static_cast<btScalar>(std::sqrt(kFriction));  // it multiplies both
    info.m_startWorldTransform.setIdentity();
    info.m_startWorldTransform.setOrigin(
        btVector3(static_cast<btScalar>(x), static_cast<btScalar>(y), 0));
    shapes_.push_back(std::move(shape));
    all_.push_back(std::make_unique<btRigidBody>(info));
    world_.addRigidBody(all_.back().get());
    return all_.back().get();
  }
  btDefaultCollisionConfiguration configuration_;
  btCollisionDispatcher dispatcher_;
  btDbvtBroadphase broadphase_;
  btSequentialImpulseConstraintSolver solver_;
  btDiscreteDynamicsWorld world_;
  std::vector<std::unique_ptr<btCollisionShape>> shapes_;
  std::vector<std::unique_ptr<btRigidBody>> all_;
  std::vector<btRigidBody*> bodies_;
};

Measured run(Engine& engine, const std::vector<Block>& blocks, double dt) {
  using Clock = std::chrono::steady_clock;
  Measured m;
  Meter meter(blocks);
  const auto steps = std::lround(kDuration / dt), each = std::max(1L, std::lround(kLook / dt));
  double push = kPush;
  for (long n = 0; n < steps; ++n) {
    if (push > 0 && static_cast<double>(n) * dt >= kPushed) engine.push(push = 0);
    const auto start = Clock::now();
    engine.step(dt);
    m.seconds += std::chrono::duration<double>(Clock::now() - start).count();
    if (n % each == 0) meter.look(engine.poses(), push);
  }
  m.depth = meter.deepest(), m.growth = meter.growth(), m.steps = steps;
  return m;
}

}  // namespace

// peers BOX2D|CHIPMUNK|BULLET COLUMNS COURSES DT -> one line of CSV
int main(int argc, char** argv) {
  if (argc != 5) {
    std::fprintf(stderr, "usage: peers box2d|chipmunk|bullet COLUMNS COURSES STEP\n");
    return 2;
  }
  const std::vector<Block> blocks = tower(std::atoi(argv[2]), std::atoi(argv[3]));
  const double dt = std::atof(argv[4]);
  std::unique_ptr<Engine> engine;
  if (std::strcmp(argv[1], "box2d") == 0) engine = std::make_unique<Box2D>(blocks);
  if (std::strcmp(argv[1], "chipmunk") == 0) engine = std::make_unique<Chipmunk>(blocks);
  if (std::strcmp(argv[1], "bullet") == 0) engine = std::make_unique<Bullet>(blocks);
  if (!engine || !(dt > 0)) return 2;
  const Measured m = run(*engine, blocks, dt);
  double potential = 0;
  for (const Block& b : blocks) potential += b.mass() * kGravity * b.y;
  std::printf("%s,%zu,%g,%ld,%.3f,%.1f,%.3g,%.3g\n", argv[1], blocks.size(), dt, m.steps, m.seconds,
              1e9 * m.seconds / static_cast<double>(m.steps) / static_cast<double>(blocks.size()),
              1e3 * m.depth, m.growth / potential);
}

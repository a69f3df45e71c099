// The same falling wall in physics engines for games, beside wythe: time of a step and block, how deep blocks lie in
// each other, whether energy grows (benchmarks/README.md). Needs libbox2d-dev, chipmunk-dev and libbullet-dev.
//
// A dry tower, columns x courses in running bond, friction 0.6, no rebound. The ground is accelerated by 0.5 g for a
// second, which a rigid tower of these proportions cannot bear; in its own frame that is a constant force, so the sum
// of kinetic energy and potential (weight and that force) may only fall.
#include <box2d/box2d.h>
#include <btBulletDynamicsCommon.h>
#include <chipmunk/chipmunk.h>

#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <ctime>
#include <memory>
#include <string>
#include <vector>

#include "meter.h"

namespace {

using namespace peers;

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
  Measured m;
  Meter meter(blocks);
  const auto steps = std::lround(kDuration / dt), each = std::max(1L, std::lround(kLook / dt));
  double push = kPush;
  for (long n = 0; n < steps; ++n) {
    if (push > 0 && static_cast<double>(n) * dt >= kPushed) engine.push(push = 0);
    const std::clock_t start = std::clock();  // processor's time
    engine.step(dt);
    m.seconds += static_cast<double>(std::clock() - start) / CLOCKS_PER_SEC;
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

#include "contact_physics.hpp"

namespace scrubjay::sim {
namespace {

b2Vec2 to_box2d(const Point2& p) {
  return {static_cast<float>(p.x()), static_cast<float>(p.y())};
}

}  // namespace

ContactPhysics::ContactPhysics(std::span<const SolidSegment> solids, double radius, double friction)
    : world_(std::make_unique<b2World>(b2Vec2(0.0f, 0.0f))), friction_(static_cast<float>(friction)) {
  // A robot moves millimetres a tick, far less than its radius: nothing can be tunnelled through.
  world_->SetContinuousPhysics(false);
  world_->SetAllowSleeping(false);

  b2BodyDef ground_def;
  b2Body* ground = world_->CreateBody(&ground_def);
  for (const SolidSegment& solid : solids) {
    b2EdgeShape edge;
    edge.SetTwoSided(to_box2d(solid.segment.a), to_box2d(solid.segment.b));
    edge.m_radius = 0.0f;  // no skin: the robot touches where the wall is
    b2FixtureDef fixture;
    fixture.shape = &edge;
    fixture.friction = friction_;
    ground->CreateFixture(&fixture);
  }

  b2BodyDef robot_def;
  robot_def.type = b2_dynamicBody;
  robot_def.fixedRotation = true;
  robot_ = world_->CreateBody(&robot_def);
  b2CircleShape disc;
  disc.m_radius = static_cast<float>(radius);
  b2FixtureDef fixture;
  fixture.shape = &disc;
  fixture.density = 1.0f;
  fixture.friction = friction_;
  robot_->CreateFixture(&fixture);
}

void ContactPhysics::place_others(std::span<const Disc> others) {
  while (others_.size() < others.size()) {
    b2CircleShape shape;
    shape.m_radius = static_cast<float>(others[others_.size()].radius);
    b2FixtureDef fixture;
    fixture.shape = &shape;
    fixture.friction = friction_;
    b2BodyDef definition;
    others_.push_back(world_->CreateBody(&definition));
    others_.back()->CreateFixture(&fixture);
  }
  for (std::size_t i = 0; i < others.size(); ++i) others_[i]->SetTransform(to_box2d(others[i].center), 0.0f);
}

Point2 ContactPhysics::push(const Point2& from, const Point2& step, double dt) {
  constexpr int kVelocityIterations = 6;  // Box2D's manual recommends 8 and 3; one disc needs less
  constexpr int kPositionIterations = 2;
  const b2Vec2 start = to_box2d(from);
  robot_->SetTransform(start, 0.0f);
  robot_->SetLinearVelocity(to_box2d(step / dt));
  world_->Step(static_cast<float>(dt), kVelocityIterations, kPositionIterations);
  const b2Vec2 end = robot_->GetPosition();
  return from + Point2(static_cast<double>(end.x) - static_cast<double>(start.x),
                       static_cast<double>(end.y) - static_cast<double>(start.y));
}

}  // namespace scrubjay::sim

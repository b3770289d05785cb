/// \file
/// A growing map from bumpers and light signals.
#pragma once

#include <scrubjay/grid/contact_model.hpp>
#include <scrubjay/mapping/growing_map.hpp>
#include <scrubjay/mapping/mapper.hpp>

namespace scrubjay {

class ContactMapper final : public Mapper {
 public:
  /// The map covers `reach` [m] around its origin from the start, and grows from there; what comes out is the same.
  ContactMapper(const RobotModel& robot, double resolution, const ContactModelParams& params = {}, double reach = 0.0)
      : model_(robot, params), map_(resolution) {
    if (reach > 0.0) map_.cover(Point2(0.0, 0.0), reach);
  }

  void update(const Frame& frame, const PoseEstimate& estimate) override {
    changed_ = {};
    if (!model_.wants(frame, estimate.pose)) return model_.integrate(frame, estimate.pose, map_.view());
    map_.cover(estimate.pose.position(), model_.reach());
    model_.integrate(frame, estimate.pose, map_.view());
    changed_ = cells_around(map_.view().geometry, estimate.pose.position(), model_.reach());
  }
  CellRect changed() const override { return changed_; }
  GridView<const LogOdds> map() const override { return map_.view(); }
  OccupancyGrid occupancy() const override { return map_.occupancy(); }

 private:
  ContactModel model_;
  GrowingMap map_;
  CellRect changed_;
};

}  // namespace scrubjay

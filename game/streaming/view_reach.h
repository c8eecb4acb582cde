// SPDX-License-Identifier: MIT
#pragma once

namespace sl {

/// How much of the view distance is shown, so that frames come often enough; a resource. A slow machine sees less far rather
/// than in jerks, and farther again where there is little to see.
class ViewReach {
  public:
    /// Never less of the distance than this.
    static constexpr double least = 0.5;

    /// After a frame that took so long, s; 0: the game rests. `least_rate`: frames per second, 0 where all is always shown.
    void follow(double seconds, double least_rate);
    double share() const { return share_; }

  private:
    double share_ = 1.0;
    double mean_ = 0.0;   ///< of what frames take, s
    double since_ = 0.0;  ///< s that the share has been what it is
};

}  // namespace sl

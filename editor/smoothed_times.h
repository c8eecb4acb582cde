// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

namespace sl {

/// Times that people can read while they flicker: means that follow slowly, by name.
class SmoothedTimes {
  public:
    /// The mean with the newest frame's value in it.
    double follow(const std::string& name, double newest) {
        double& mean = means_.try_emplace(name, newest).first->second;
        mean += share_of_newest * (newest - mean);
        return mean;
    }

  private:
    static constexpr double share_of_newest = 0.1;
    std::map<std::string, double> means_;
};

}  // namespace sl

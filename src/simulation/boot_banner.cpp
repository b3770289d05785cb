#include "boot_banner.hpp"

namespace scrubjay::sim {

std::string boot_loader_banner() {
  return "bl-start\r\n"
         "STR730\r\n"
         "bootloader id: #x47175347 00000000\r\n"
         "bootloader info rev: #xF000\r\n"
         "bootloader rev: #x0001\r\n"
         "2007-05-14-1715-L\r\n";
}

std::string ready_banner(const oi::Release& release) {
  const std::string number = std::to_string(release.major_number) + "." + std::to_string(release.minor_number) + "." +
                             std::to_string(release.patch);
  return "Roomba by iRobot!\r\n"
         "r3_robot/tags/release-" +
         number + ":0 CLEAN\r\n";
}

}  // namespace scrubjay::sim

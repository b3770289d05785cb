# Microcontrollers without an operating system, by Debian's gcc-arm-none-eabi. SCRUBJAY_CPU says which.
set(CMAKE_SYSTEM_NAME Generic)
set(CMAKE_SYSTEM_PROCESSOR arm)
set(CMAKE_C_COMPILER arm-none-eabi-gcc)
set(CMAKE_CXX_COMPILER arm-none-eabi-g++)
set(CMAKE_TRY_COMPILE_TARGET_TYPE STATIC_LIBRARY)  # a program would want a linker script
set(CMAKE_TRY_COMPILE_PLATFORM_VARIABLES SCRUBJAY_CPU)

set(SCRUBJAY_CPU cortex-m3 CACHE STRING "cortex-m3 or cortex-m4f")
if(SCRUBJAY_CPU STREQUAL "cortex-m3")
  set(cpu "-mcpu=cortex-m3 -mthumb")
  set(machine mps2-an385)
elseif(SCRUBJAY_CPU STREQUAL "cortex-m4f")
  set(cpu "-mcpu=cortex-m4 -mthumb -mfloat-abi=hard -mfpu=fpv4-sp-d16")
  set(machine mps2-an386)
else()
  message(FATAL_ERROR "SCRUBJAY_CPU is ${SCRUBJAY_CPU}; want cortex-m3 or cortex-m4f")
endif()
set(CMAKE_C_FLAGS_INIT "${cpu} -ffunction-sections -fdata-sections")
set(CMAKE_CXX_FLAGS_INIT "${CMAKE_C_FLAGS_INIT} -fno-exceptions -fno-rtti -fno-threadsafe-statics -Wno-psabi")
set(CMAKE_ASM_FLAGS_INIT "${cpu}")
set(CMAKE_CROSSCOMPILING_EMULATOR qemu-system-arm -M ${machine} -display none -monitor none -serial none
  -icount shift=0 -semihosting-config enable=on,target=native -kernel)

// The recording, in a section of its own: no part of the code.
  .section .recording, "a"
  .global recording_begin
  .global recording_end
recording_begin:
  .incbin RECORDING
recording_end:
#ifdef __linux__
  .section .note.GNU-stack, "", %progbits
#endif

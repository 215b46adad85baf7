/* A driver's own test in C. */

#include <halftone/c/m508.h>

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* What the driver that is tested sends: the example of `fill` in docs/protocol.md, (10, 20), 30 x 40, orange.
 */
static const uint8_t fill[] = {0x4D, 0x35, 0x13, 0x00, 0x00, 0x00, 0x07, 0x00, 0x0B, 0x00, 0x0A, 0x00,
                               0x14, 0x00, 0x1E, 0x00, 0x28, 0xFF, 0x80, 0x00, 0x61, 0xD8, 0x95, 0xA2};
/* And of `status`. */
static const uint8_t status[] = {0x4D, 0x35, 0x03, 0, 0, 0, 0x07, 0, 0, 0x30, 0x5E, 0xA1, 0xFF};

static void require(int condition, const char* what) {
  if (condition) return;
  fprintf(stderr, "not so: %s\n", what);
  exit(1);
}

int main(void) {
  uint8_t rgb[3], reply[64];
  uint8_t* screen = malloc(M508_SCREEN_SIZE);
  m508* device = m508_create();
  require(device != NULL && screen != NULL, "there is memory");

  for (size_t i = 0; i < sizeof fill; ++i) /* in pieces of any size */
    require(m508_send(device, fill + i, 1) == 0, "a byte is taken");
  require(m508_errors_of(device).count == 0, "the device understood it");
  require(m508_commands(device) == 1, "it was one command");

  m508_pixel(device, 0, 39, 59, rgb);
  require(rgb[0] == 0xFF && rgb[1] == 0x80 && rgb[2] == 0, "the last pixel is orange");
  m508_shown(device, 40, 59, rgb);
  require(rgb[0] == 0 && rgb[1] == 0 && rgb[2] == 0, "the next one is black");
  m508_screen(device, screen);
  require(memcmp(screen + (20 * M508_WIDTH + 10) * 3, "\xFF\x80\x00", 3) == 0, "the screen shows it");

  require(m508_receive(device, reply, sizeof reply) == 0, "fill has no answer");
  m508_send(device, status, sizeof status);
  require(m508_receive(device, reply, sizeof reply) == 34 && reply[2] == 0x83, "status has one");

  const uint32_t before = m508_state_checksum(device);
  m508_send(device, fill, 10);
  m508_end(device);
  require(m508_errors_of(device).first == 1, "a command that is cut off is damage");
  require(m508_state_checksum(device) == before, "and changes nothing else");

  m508_destroy(device);
  free(screen);
  return 0;
}

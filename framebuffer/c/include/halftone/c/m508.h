/* The emulated frame buffer, for the tests of drivers that are written in C.
 *
 * A device takes the bytes that a driver would send (docs/protocol.md), in pieces of any size, and gives back
 * what it would answer. It never prints, exits or blocks, and a device may be used by one thread at a time;
 * different devices have nothing in common.
 *
 * Pixels are 3 bytes: red, green, blue. Columns count from the left, rows from the top, both from 0 to 511.
 * A null device, or a null pointer to a non-empty buffer, is a broken contract. */
#ifndef HALFTONE_C_M508_H
#define HALFTONE_C_M508_H

#include <stddef.h>
#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

enum { M508_WIDTH = 512, M508_HEIGHT = 512, M508_SCREEN_SIZE = 512 * 512 * 3 };

typedef struct m508 m508;

/* A device as at power-on, on a bus that takes no time; null if there is no memory. */
m508* m508_create(void);
void m508_destroy(m508* device); /* null is allowed */

/* Sends bytes to the device. 0, or -1 if there was no memory; the device must then be destroyed. */
int m508_send(m508* device, const uint8_t* bytes, size_t size);

/* The line falls silent: an unfinished command will not be finished, and counts as damage. As m508_send. */
int m508_end(m508* device);

/* Takes up to size bytes of what the device has answered and has not been taken; returns how many. */
size_t m508_receive(m508* device, uint8_t* bytes, size_t size);

/* A pixel of an image buffer, 0 or 1, as it stands in memory. */
void m508_pixel(const m508* device, int buffer, int x, int y, uint8_t rgb[3]);

/* A pixel as the screen shows it now. */
void m508_shown(const m508* device, int x, int y, uint8_t rgb[3]);

/* The screen as it is shown now: M508_SCREEN_SIZE bytes, rows from the top. */
void m508_screen(const m508* device, uint8_t* rgb);

/* The error status: code of the first error since the reset (0: none), the sequence number of its command,
 * and the count of errors. */
typedef struct m508_errors {
  int first;
  uint32_t sequence;
  uint32_t count;
} m508_errors;
m508_errors m508_errors_of(const m508* device);

/* Commands executed since the reset, without queries. */
uint32_t m508_commands(const m508* device);

/* CRC-32 of all that decides the picture and where writing goes on (docs/protocol.md, state checksum). */
uint32_t m508_state_checksum(const m508* device);

#ifdef __cplusplus
}
#endif

#endif

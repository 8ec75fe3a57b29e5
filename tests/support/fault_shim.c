/* Preloaded into a program under test: the n-th call that changes files kills the process or fails.
 *
 *   FLOE_FAULT_AT=n      which call, counted from 1 over all threads
 *   FLOE_FAULT=kill      SIGKILL before the call; a write has put half of its bytes down by then
 *   FLOE_FAULT=28        the call fails with this errno
 *   FLOE_FAULT_FOREVER=1 so do all later ones
 *   FLOE_FAULT_FILE=name no write to a file whose name holds this succeeds, and none is counted
 *   FLOE_FREE_SPACE=b    so many bytes are free on every disk
 *   FLOE_NO_LOCKS=1      flock fails as on a file system without locks
 *   FLOE_FAULT_COUNT=f   the number of calls is written to this file when the process exits
 *
 * Counted are write and pwrite but to the standard streams, fsync, rename, ftruncate, unlink, mkdir
 * and open with O_CREAT. */
#define _GNU_SOURCE
#include <dlfcn.h>
#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <stdarg.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <sys/statvfs.h>
#include <sys/syscall.h>
#include <sys/types.h>
#include <unistd.h>

static atomic_long calls;

static long number(const char* name) {
  const char* text = getenv(name);
  return text ? atol(text) : 0;
}

static int due(void) {
  const long call = atomic_fetch_add(&calls, 1) + 1, at = number("FLOE_FAULT_AT");
  return at > 0 && (call == at || (call > at && number("FLOE_FAULT_FOREVER")));
}

/* Returns only where the call is to fail, with errno set */
static void strike(void) {
  const char* fault = getenv("FLOE_FAULT");
  if (fault && strcmp(fault, "kill") == 0) {
    kill(getpid(), SIGKILL);
    for (;;) pause();
  }
  errno = fault ? atoi(fault) : EIO;
}

__attribute__((destructor)) static void tell_count(void) {
  const char* path = getenv("FLOE_FAULT_COUNT");
  if (!path) return;
  char text[32];
  const int length = snprintf(text, sizeof text, "%ld\n", atomic_load(&calls));
  const int file = (int)syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_TRUNC, 0600);
  syscall(SYS_write, file, text, (size_t)length);
  syscall(SYS_close, file);
}

#define REAL(name) ((__typeof__(&name))dlsym(RTLD_NEXT, #name))

static int kills(void) {
  const char* fault = getenv("FLOE_FAULT");
  return fault && strcmp(fault, "kill") == 0;
}

/* Whether a write goes to the file that takes none */
static int is_faulty(int file) {
  const char* name = getenv("FLOE_FAULT_FILE");
  char link[64], path[4096];
  if (!name || file <= 2) return 0;
  snprintf(link, sizeof link, "/proc/self/fd/%d", file);
  const ssize_t length = readlink(link, path, sizeof path - 1);
  if (length < 0) return 0;
  path[length] = 0;
  return strstr(path, name) != NULL;
}

#define FAIL_WHEN_FAULTY \
  if (is_faulty(file)) { \
    strike();            \
    return -1;           \
  }

ssize_t write(int file, const void* bytes, size_t count) {
  FAIL_WHEN_FAULTY
  if (file > 2 && due()) {
    if (kills()) syscall(SYS_write, file, bytes, count / 2);
    strike();
    return -1;
  }
  return REAL(write)(file, bytes, count);
}

ssize_t pwrite(int file, const void* bytes, size_t count, off_t at) {
  FAIL_WHEN_FAULTY
  if (due()) {
    if (kills()) syscall(SYS_pwrite64, file, bytes, count / 2, at);
    strike();
    return -1;
  }
  return REAL(pwrite)(file, bytes, count, at);
}

ssize_t pwrite64(int file, const void* bytes, size_t count, off64_t at) {
  FAIL_WHEN_FAULTY
  if (due()) {
    if (kills()) syscall(SYS_pwrite64, file, bytes, count / 2, at);
    strike();
    return -1;
  }
  return REAL(pwrite64)(file, bytes, count, at);
}

#define FAIL_WHEN_DUE \
  if (due()) {        \
    strike();         \
    return -1;        \
  }

int fsync(int file) {
  FAIL_WHEN_DUE
  return REAL(fsync)(file);
}

int rename(const char* from, const char* to) {
  FAIL_WHEN_DUE
  return REAL(rename)(from, to);
}

int ftruncate(int file, off_t length) {
  FAIL_WHEN_DUE
  return REAL(ftruncate)(file, length);
}

int unlink(const char* path) {
  FAIL_WHEN_DUE
  return REAL(unlink)(path);
}

int mkdir(const char* path, mode_t mode) {
  FAIL_WHEN_DUE
  return REAL(mkdir)(path, mode);
}

int flock(int file, int operation) {
  if (getenv("FLOE_NO_LOCKS")) {
    errno = ENOLCK;
    return -1;
  }
  return REAL(flock)(file, operation);
}

static mode_t mode_of(int flags, va_list* rest) {
  return flags & (O_CREAT | O_TMPFILE) ? (mode_t)va_arg(*rest, int) : 0;
}

int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = mode_of(flags, &rest);
  va_end(rest);
  if (flags & O_CREAT) FAIL_WHEN_DUE
  return REAL(open)(path, flags, mode);
}

int open64(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const mode_t mode = mode_of(flags, &rest);
  va_end(rest);
  if (flags & O_CREAT) FAIL_WHEN_DUE
  return REAL(open64)(path, flags, mode);
}

static int told_space(int result, unsigned long size, fsblkcnt64_t* available) {
  if (getenv("FLOE_FREE_SPACE")) *available = (fsblkcnt64_t)number("FLOE_FREE_SPACE") / size;
  return result;
}

int statvfs(const char* path, struct statvfs* status) {
  const int result = REAL(statvfs)(path, status);
  return told_space(result, status->f_frsize, &status->f_bavail);
}

int statvfs64(const char* path, struct statvfs64* status) {
  const int result = REAL(statvfs64)(path, status);
  return told_space(result, status->f_frsize, &status->f_bavail);
}

/*
 * The C baseline: MAVLink 2 written down once more in C, with the algorithms of the C library that mavgen generates (a state machine
 * that takes byte by byte, a checksum step per byte without a table, a SHA-256 of plain C; the payload is copied from a packed struct
 * into the message and from there to the wire). Own code under the licence of the repository, so that the figures can be made anywhere.
 *
 *   gcc -O2 -o baseline baseline.c && ./baseline frames.bin crc-extra.bin
 *
 * frames.bin: unsigned MAVLink 2 frames back to back. crc-extra.bin: one CRC_EXTRA byte per frame, in order.
 * Prints "name nanoseconds-per-frame", best of many passes of about 2 ms.
 */
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

enum { MAGIC = 0xFD, HEADER = 10, MAX_PAYLOAD = 255, MAX_FRAME = 280, ID_COUNT = 1 << 24, FEW = 1000 };

typedef struct {
    uint16_t checksum;
    uint8_t magic, len, incompat, compat, seq, sysid, compid;
    uint32_t msgid;
    uint8_t payload[MAX_PAYLOAD + 2];
    uint8_t ck[2];
    uint8_t signature[13];
} message_t;

/* CRC-16/MCRF4XX in the form of avr-libc's _crc_ccitt_update, which every C implementation of MAVLink uses. */
static inline void crc_accumulate(uint8_t data, uint16_t *crc)
{
    uint8_t tmp = data ^ (uint8_t)(*crc & 0xFF);
    tmp ^= (uint8_t)(tmp << 4);
    *crc = (uint16_t)((*crc >> 8) ^ (tmp << 8) ^ (tmp << 3) ^ (tmp >> 4));
}

static uint16_t crc_of(const uint8_t *bytes, size_t length, uint16_t crc)
{
    while (length--)
        crc_accumulate(*bytes++, &crc);
    return crc;
}

/* ---- SHA-256 (FIPS 180-4) ---- */

static const uint32_t K[64] = {
    0x428A2F98, 0x71374491, 0xB5C0FBCF, 0xE9B5DBA5, 0x3956C25B, 0x59F111F1, 0x923F82A4, 0xAB1C5ED5, 0xD807AA98, 0x12835B01, 0x243185BE,
    0x550C7DC3, 0x72BE5D74, 0x80DEB1FE, 0x9BDC06A7, 0xC19BF174, 0xE49B69C1, 0xEFBE4786, 0x0FC19DC6, 0x240CA1CC, 0x2DE92C6F, 0x4A7484AA,
    0x5CB0A9DC, 0x76F988DA, 0x983E5152, 0xA831C66D, 0xB00327C8, 0xBF597FC7, 0xC6E00BF3, 0xD5A79147, 0x06CA6351, 0x14292967, 0x27B70A85,
    0x2E1B2138, 0x4D2C6DFC, 0x53380D13, 0x650A7354, 0x766A0ABB, 0x81C2C92E, 0x92722C85, 0xA2BFE8A1, 0xA81A664B, 0xC24B8B70, 0xC76C51A3,
    0xD192E819, 0xD6990624, 0xF40E3585, 0x106AA070, 0x19A4C116, 0x1E376C08, 0x2748774C, 0x34B0BCB5, 0x391C0CB3, 0x4ED8AA4A, 0x5B9CCA4F,
    0x682E6FF3, 0x748F82EE, 0x78A5636F, 0x84C87814, 0x8CC70208, 0x90BEFFFA, 0xA4506CEB, 0xBEF9A3F7, 0xC67178F2,
};

typedef struct {
    uint32_t state[8];
    uint64_t length;
    uint8_t block[64];
} sha256_t;

#define ROR(x, n) (((x) >> (n)) | ((x) << (32 - (n))))

static void sha256_block(sha256_t *s)
{
    uint32_t w[64];
    for (int i = 0; i < 16; i++)
        w[i] = ((uint32_t)s->block[4 * i] << 24) | (s->block[4 * i + 1] << 16) | (s->block[4 * i + 2] << 8) | s->block[4 * i + 3];
    for (int i = 16; i < 64; i++)
        w[i] = (ROR(w[i - 2], 17) ^ ROR(w[i - 2], 19) ^ (w[i - 2] >> 10)) + w[i - 7]
            + (ROR(w[i - 15], 7) ^ ROR(w[i - 15], 18) ^ (w[i - 15] >> 3)) + w[i - 16];
    uint32_t a = s->state[0], b = s->state[1], c = s->state[2], d = s->state[3];
    uint32_t e = s->state[4], f = s->state[5], g = s->state[6], h = s->state[7];
    for (int i = 0; i < 64; i++) {
        uint32_t t1 = h + (ROR(e, 6) ^ ROR(e, 11) ^ ROR(e, 25)) + ((e & f) ^ (~e & g)) + K[i] + w[i];
        uint32_t t2 = (ROR(a, 2) ^ ROR(a, 13) ^ ROR(a, 22)) + ((a & b) ^ (a & c) ^ (b & c));
        h = g; g = f; f = e; e = d + t1; d = c; c = b; b = a; a = t1 + t2;
    }
    s->state[0] += a; s->state[1] += b; s->state[2] += c; s->state[3] += d;
    s->state[4] += e; s->state[5] += f; s->state[6] += g; s->state[7] += h;
}

static void sha256_init(sha256_t *s)
{
    static const uint32_t start[8] = {
        0x6A09E667, 0xBB67AE85, 0x3C6EF372, 0xA54FF53A, 0x510E527F, 0x9B05688C, 0x1F83D9AB, 0x5BE0CD19 };
    memcpy(s->state, start, sizeof start);
    s->length = 0;
}

static void sha256_update(sha256_t *s, const void *data, size_t length)
{
    const uint8_t *bytes = data;
    while (length > 0) {
        size_t used = s->length % 64, part = 64 - used < length ? 64 - used : length;
        memcpy(s->block + used, bytes, part);
        s->length += part;
        bytes += part;
        length -= part;
        if (s->length % 64 == 0)
            sha256_block(s);
    }
}

static void sha256_final_48(sha256_t *s, uint8_t out[6])
{
    static const uint8_t padding[64] = { 0x80 };
    uint64_t bits = s->length * 8;
    uint8_t tail[8];
    sha256_update(s, padding, 1 + (119 - s->length % 64) % 64);
    for (int i = 0; i < 8; i++)
        tail[i] = (uint8_t)(bits >> (56 - 8 * i));
    sha256_update(s, tail, 8);
    for (int i = 0; i < 6; i++)
        out[i] = (uint8_t)(s->state[i / 4] >> (24 - 8 * (i % 4)));
}

/* ---- sending ---- */

static const uint8_t key[32] = { 1, 2, 3, 4, 5, 6, 7, 8, 9 };
static uint64_t timestamp = 1;
static uint8_t sequence;

static void sign(const uint8_t *wire, size_t length, uint8_t signature[13])
{
    sha256_t sha;
    signature[0] = 1;
    timestamp++;
    memcpy(signature + 1, &timestamp, 6);
    sha256_init(&sha);
    sha256_update(&sha, key, sizeof key);
    sha256_update(&sha, wire, length);
    sha256_update(&sha, signature, 7);
    sha256_final_48(&sha, signature + 7);
}

/* What mavlink_msg_X_encode and mavlink_msg_to_send_buffer do together; the fields are copied as one packed struct. */
__attribute__((noinline)) static size_t encode(
    const uint8_t *fields, uint8_t full, uint32_t msgid, uint8_t extra, int is_signed, message_t *msg, uint8_t *wire)
{
    uint8_t packet[MAX_PAYLOAD], header[HEADER];
    memcpy(packet, fields, full);
    memcpy(msg->payload, packet, full);
    uint8_t len = full;
    while (len > 1 && msg->payload[len - 1] == 0)
        len--;
    msg->msgid = msgid;
    msg->magic = header[0] = MAGIC;
    msg->len = header[1] = len;
    msg->incompat = header[2] = is_signed ? 1 : 0;
    msg->compat = header[3] = 0;
    msg->seq = header[4] = sequence++;
    msg->sysid = header[5] = 1;
    msg->compid = header[6] = 191;
    header[7] = (uint8_t)msgid;
    header[8] = (uint8_t)(msgid >> 8);
    header[9] = (uint8_t)(msgid >> 16);
    uint16_t crc = crc_of(msg->payload, len, crc_of(header + 1, HEADER - 1, 0xFFFF));
    crc_accumulate(extra, &crc);
    msg->checksum = crc;
    memcpy(wire, header, HEADER);
    memcpy(wire + HEADER, msg->payload, len);
    wire[HEADER + len] = msg->ck[0] = (uint8_t)crc;
    wire[HEADER + len + 1] = msg->ck[1] = (uint8_t)(crc >> 8);
    if (!is_signed)
        return HEADER + len + 2;
    sign(wire, HEADER + len + 2, msg->signature);
    memcpy(wire + HEADER + len + 2, msg->signature, 13);
    return HEADER + len + 2 + 13;
}

/* ---- receiving: one state per byte, the checksum taken along ---- */

typedef struct {
    int state;
    unsigned index;
    uint16_t crc;
    message_t msg;
} parser_t;

static uint8_t *extras; /* by message id */

__attribute__((noinline)) static int parse_char(parser_t *p, uint8_t c, message_t *out)
{
    message_t *m = &p->msg;
    switch (p->state) {
    case 0:
        if (c == MAGIC) {
            m->magic = c;
            p->crc = 0xFFFF;
            p->state = 1;
        }
        return 0;
    case 1: m->len = c; break;
    case 2: m->incompat = c; break;
    case 3: m->compat = c; break;
    case 4: m->seq = c; break;
    case 5: m->sysid = c; break;
    case 6: m->compid = c; break;
    case 7: m->msgid = c; break;
    case 8: m->msgid |= (uint32_t)c << 8; break;
    case 9:
        m->msgid |= (uint32_t)c << 16;
        p->index = 0;
        if (m->len == 0)
            p->state = 10;
        break;
    case 10:
        m->payload[p->index++] = c;
        crc_accumulate(c, &p->crc);
        if (p->index == m->len)
            p->state = 11;
        return 0;
    case 11:
        crc_accumulate(extras[m->msgid], &p->crc);
        m->ck[0] = c;
        p->state = c == (p->crc & 0xFF) ? 12 : 0;
        return 0;
    default:
        p->state = 0;
        m->ck[1] = c;
        if (c != p->crc >> 8)
            return 0;
        m->checksum = p->crc;
        memset(m->payload + m->len, 0, MAX_PAYLOAD - m->len);
        memcpy(out, m, sizeof *m);
        return 1;
    }
    crc_accumulate(c, &p->crc);
    p->state++;
    return 0;
}

/* ---- measuring ---- */

typedef struct { uint8_t fields[MAX_PAYLOAD]; uint8_t full, extra; uint32_t msgid; } sample_t;

static uint8_t *stream;
static size_t stream_length;
static sample_t *samples;
static int sample_count;
static volatile uint64_t checked;

static double seconds(void)
{
    struct timespec t;
    clock_gettime(CLOCK_MONOTONIC, &t);
    return t.tv_sec + t.tv_nsec * 1e-9;
}

static void work_read(void)
{
    static parser_t parser;
    static message_t out;
    for (size_t i = 0; i < stream_length; i++)
        if (parse_char(&parser, stream[i], &out))
            checked += out.seq;
}

static void work_encode(void)
{
    static message_t msg;
    static uint8_t wire[MAX_FRAME];
    for (int i = 0; i < sample_count; i++)
        checked += encode(samples[i].fields, samples[i].full, samples[i].msgid, samples[i].extra, 0, &msg, wire);
}

static void work_encode_sign(void)
{
    static message_t msg;
    static uint8_t wire[MAX_FRAME];
    int few = sample_count < FEW ? sample_count : FEW;
    for (int i = 0; i < few; i++)
        checked += encode(samples[i].fields, samples[i].full, samples[i].msgid, samples[i].extra, 1, &msg, wire);
}

static void measure(const char *name, void (*work)(void), int frames)
{
    double best = 1e9;
    for (int pass = 0; pass < 300; pass++) {
        double start = seconds();
        work();
        double took = seconds() - start;
        if (took < best)
            best = took;
    }
    printf("%s %.1f\n", name, best / frames * 1e9);
}

static uint8_t *load(const char *path, size_t *length)
{
    FILE *file = fopen(path, "rb");
    if (!file) {
        perror(path);
        exit(2);
    }
    fseek(file, 0, SEEK_END);
    *length = (size_t)ftell(file);
    rewind(file);
    uint8_t *bytes = malloc(*length + 1);
    if (fread(bytes, 1, *length, file) != *length)
        exit(2);
    fclose(file);
    return bytes;
}

int main(int argc, char **argv)
{
    size_t extra_count;
    if (argc != 4)
        return 2;
    stream = load(argv[1], &stream_length);
    uint8_t *crc_extras = load(argv[2], &extra_count);
    uint8_t *lengths = load(argv[3], &extra_count);   /* payload length before trailing zeros are cut */
    samples = calloc(extra_count, sizeof *samples);
    extras = calloc(ID_COUNT, 1);
    for (size_t at = 0; at < stream_length; sample_count++) {
        sample_t *s = &samples[sample_count];
        memcpy(s->fields, stream + at + HEADER, stream[at + 1]);
        s->full = lengths[sample_count];
        s->extra = crc_extras[sample_count];
        s->msgid = stream[at + 7] | (stream[at + 8] << 8) | ((uint32_t)stream[at + 9] << 16);
        extras[s->msgid] = s->extra;
        at += HEADER + stream[at + 1] + 2;
    }
    measure("read", work_read, sample_count);
    measure("encode", work_encode, sample_count);
    measure("encode-sign", work_encode_sign, sample_count < FEW ? sample_count : FEW);
    return 0;
}
